library ieee; use ieee.std_logic_1164.all;
entity e is generic (n : integer := 2; release : integer); port (clk : in std_logic; v : in bit_vector(1 to n)); end;
architecture a of e is
  subtype word is std_logic_vector(7 downto 0); type words is array (0 to 3) of word;
  signal m : words; attribute ram_init_file of m : signal is "m.mif";
begin
  process begin wait until (clk = '1'); outer : case c is -- when
    when 0 to n - 1 | n => case v is when x"3" => null; when others => exit when b; end case;
    when v'range | integer range 5 downto n => q <= a when c else b;
    when others => null; end case outer; end process;
  with c select (q, r) <= "01" when n, f(a, b) when 3 | 4, "10" when others;
  -- altera translate_off
  with c select?
  -- altera translate_on
  -- synthesis read_comments_as_HDL on
  --  g : case n generate when 1 => end generate;
  -- synthesis read_comments_as_HDL off
end;
