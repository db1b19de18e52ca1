-- operations.vhd - what GHDL translates, in 1,000 clocks: LEDR ends as a signature of all of it

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity operations is
    port (
        CLOCK_50 : in  std_logic;
        LEDR     : out std_logic_vector(9 downto 0) := (others => '0'));
end entity;

architecture a of operations is
    type state is (IDLE, ONE, TWO, THREE, LOST);
    type bytes is array (0 to 15) of std_logic_vector(7 downto 0);
    type pair is record
        x : unsigned(3 downto 0);
        y : signed(7 downto 0);
    end record;
    constant ROM : bytes := (x"12", x"34", x"56", x"78", x"9a", x"bc", others => x"5a");

    signal ram          : bytes := (others => (others => '0'));
    signal s            : state := IDLE;
    signal lfsr         : std_logic_vector(15 downto 0) := x"ace1";
    signal n            : integer range 0 to 999 := 0;
    signal digits       : std_logic_vector(6 downto 0);
    signal shown        : std_logic_vector(6 downto 0);
    signal p            : pair := (x => "0000", y => x"80");
    signal sum          : signed(15 downto 0) := (others => '0');
    signal big          : unsigned(39 downto 0) := x"123456789a";
    -- Names that are keywords of Verilog.
    signal reg, initial : unsigned(7 downto 0) := x"3c";
    signal table        : unsigned(7 downto 0);

    signal a, b         : signed(7 downto 0);
    signal all_bits     : std_logic_vector(119 downto 0);
    signal signature    : std_logic_vector(9 downto 0) := (others => '0');

    function parity(v : std_logic_vector) return std_logic is
        variable odd : std_logic := '0';
    begin
        for i in v'range loop
            odd := odd xor v(i);
        end loop;
        return odd;
    end function;
begin
    process (CLOCK_50)
        variable mask : std_logic_vector(119 downto 0);
        variable t : unsigned(7 downto 0);
        variable k : integer range -128 to 127;
    begin
        if rising_edge(CLOCK_50) and n /= 999 then
            n    <= n + 1;
            lfsr <= lfsr(14 downto 0) & (lfsr(15) xor lfsr(13) xor lfsr(12) xor lfsr(10));
            case s is
                when IDLE   => s <= ONE;
                when ONE    => if lfsr(0) = '1' then s <= TWO; end if;
                when TWO    => s <= THREE;
                when others => s <= IDLE;
            end case;
            t := reg + unsigned(lfsr(7 downto 0));
            if t > 100 then
                t := t - 37;
            elsif t < 20 then
                t := rotate_left(t, 3);
            end if;
            reg     <= t;
            initial <= shift_right(t, 2) xor initial;
            p.x     <= p.x + 3;
            p.y     <= p.y + signed(resize(p.x, 8));
            sum     <= sum + signed(lfsr(7 downto 0)) * p.y;
            case lfsr(3 downto 0) is
                when x"0"   => big <= x"ffffffffff";
                when x"1"   => big <= x"0123456789";
                when x"2"   => big <= big + 1;
                when x"5"   => big <= big(0) & big(39 downto 1);
                when others => big <= big xor x"aaaaaaaaaa";
            end case;
            k := to_integer(signed(lfsr(7 downto 0)));
            if k mod 7 = 3 or n rem 5 = 2 then
                ram(to_integer(unsigned(lfsr(3 downto 0)))) <= std_logic_vector(to_signed(k, 8));
            end if;
            mask := x"d3a5c69e1b7842f0" & lfsr & std_logic_vector(big);
            signature <= signature(8 downto 0) & (signature(9) xor parity(all_bits and mask));
        end if;
    end process;

    process (all)
    begin
        case n mod 10 is
            when 0      => digits <= "1000000";
            when 1      => digits <= "1111001";
            when 2 to 4 => digits <= "0100100";
            when 7 | 8  => digits <= "0000000";
            when others => digits <= "0111111";
        end case;
    end process;

    with s select shown <=
        "0000001" when IDLE,
        "0000010" when ONE | TWO,
        "1000000" when others;

    a     <= signed(lfsr(15 downto 8));
    b     <= signed(lfsr(7 downto 0)) when lfsr(7 downto 0) /= x"00" else x"01";
    table <= unsigned(ROM(n mod 16));
    all_bits <= digits & shown
        & ram(to_integer(unsigned(lfsr(9 downto 6))))
        & std_logic_vector(a mod b) & std_logic_vector(a rem b) & std_logic_vector(a / b)
        & std_logic_vector(abs a) & std_logic_vector(shift_right(a, to_integer(p.x(2 downto 0))))
        & std_logic_vector(minimum(a, b)) & std_logic_vector(maximum(p.y, b))
        & std_logic_vector(reg + initial) & std_logic_vector(table - p.x)
        & std_logic_vector(sum) & std_logic_vector(big(39 downto 30));
    LEDR <= signature;
end architecture;
