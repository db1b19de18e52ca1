s/if (hide) blank_no/if (hide \&\& v_o[0]) blank_no/
