-- lpm.vhd - the library lpm for VHDL: a design declares those of its components that it uses.

package lpm_components is
end lpm_components;
