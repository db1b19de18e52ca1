-- altera_mf.vhd - the library altera_mf for VHDL: what is not declared in a design's own files.
--
-- Components alone; their models are Verilog, in rtl/ip.

library ieee;
use ieee.std_logic_1164.all;

package altera_mf_components is
    component altsyncram
        generic (
            operation_mode : string := "BIDIR_DUAL_PORT";
            width_a : natural := 1;
            widthad_a : natural := 1;
            numwords_a : natural := 0;
            width_byteena_a : natural := 1;
            outdata_reg_a : string := "UNREGISTERED";
            outdata_aclr_a : string := "NONE";
            address_aclr_a : string := "NONE";
            clock_enable_input_a : string := "NORMAL";
            clock_enable_output_a : string := "NORMAL";
            read_during_write_mode_port_a : string := "NEW_DATA_NO_NBE_READ";
            width_b : natural := 1;
            widthad_b : natural := 1;
            numwords_b : natural := 0;
            width_byteena_b : natural := 1;
            address_reg_b : string := "CLOCK1";
            address_aclr_b : string := "NONE";
            indata_reg_b : string := "CLOCK1";
            wrcontrol_wraddress_reg_b : string := "CLOCK1";
            rdcontrol_reg_b : string := "CLOCK1";
            byteena_reg_b : string := "CLOCK1";
            outdata_reg_b : string := "UNREGISTERED";
            outdata_aclr_b : string := "NONE";
            clock_enable_input_b : string := "NORMAL";
            clock_enable_output_b : string := "NORMAL";
            read_during_write_mode_port_b : string := "NEW_DATA_NO_NBE_READ";
            read_during_write_mode_mixed_ports : string := "DONT_CARE";
            byte_size : natural := 8;
            init_file : string := "UNUSED";
            init_file_layout : string := "UNUSED";
            maximum_depth : natural := 0;
            power_up_uninitialized : string := "FALSE";
            ram_block_type : string := "AUTO";
            intended_device_family : string := "UNUSED";
            lpm_hint : string := "UNUSED";
            lpm_type : string := "altsyncram"
        );
        port (
            clock0, clock1 : in std_logic := '1';
            clocken0, clocken1, clocken2, clocken3 : in std_logic := '1';
            aclr0, aclr1 : in std_logic := '0';
            address_a : in std_logic_vector(widthad_a - 1 downto 0);
            addressstall_a : in std_logic := '0';
            wren_a : in std_logic := '0';
            rden_a : in std_logic := '1';
            byteena_a : in std_logic_vector(width_byteena_a - 1 downto 0) := (others => '1');
            data_a : in std_logic_vector(width_a - 1 downto 0) := (others => '1');
            q_a : out std_logic_vector(width_a - 1 downto 0);
            address_b : in std_logic_vector(widthad_b - 1 downto 0) := (others => '1');
            addressstall_b : in std_logic := '0';
            wren_b : in std_logic := '0';
            rden_b : in std_logic := '1';
            byteena_b : in std_logic_vector(width_byteena_b - 1 downto 0) := (others => '1');
            data_b : in std_logic_vector(width_b - 1 downto 0) := (others => '1');
            q_b : out std_logic_vector(width_b - 1 downto 0);
            eccstatus : out std_logic_vector(2 downto 0)
        );
    end component;
end altera_mf_components;
