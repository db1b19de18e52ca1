"""wrong_systems_test.py DE1SIM FOLDER [CASE...] - Platform Designer systems that are refused"""
from case import run
from systems import BASE, LW, SystemCase, pio, qsys


class WrongSystems(SystemCase):
    def test_a_program_without_a_processor(self):
        self.write(top_v="module top(output [9:0] LEDR); assign LEDR = 1; endmodule")
        self.program("")
        self.refused("--elf: the project has no processor to run it", "run", "--elf", "program.elf",
                     "--project", ".")

    def test_broken_files(self):
        self.with_leds()
        self.write(sys_qsys="<system>\n <module name=\"a\" kind=\"b\">\n</system>\n")
        self.refused("sys.qsys:3: this is broken XML", "check", "top.qsf")
        self.write(sys_qsys="<component/>\n")
        self.refused("sys.qsys:1: this is no Platform Designer system", "check", "top.qsf")
        self.write(sys_qsys="")
        self.refused("sys.qsys:1: this is broken XML", "check", "top.qsf")

    def test_one_name_twice(self):
        self.refuses("there are two modules leds", pio("leds", 0x10)[0])

    def test_two_slaves_at_one_address(self):
        more, wires = pio("more", 0)
        self.refuses("leds.s1 and more.s1 have the same addresses of hps_0.h2f_lw_axi_master, from "
                     "0x0 on", more, wires)

    def test_a_base_within_a_span(self):
        more, wires = pio("more", 0x18)
        self.refuses("more.s1 is at 0x18, which is no multiple of its 16 bytes", more, wires)

    def test_an_interrupt_twice(self):
        keys = {"direction": "Input", "width": "4", "captureEdge": "true", "generateIRQ": "true"}
        modules, wires = [], []
        for n in (0, 1):
            port, its_wires = pio(f"keys{n}", 0x20 + 0x10 * n, **keys)
            modules += port
            wires += [*its_wires, ("interrupt", "hps_0.f2h_irq0", f"keys{n}.irq", 3)]
        self.refuses("interrupt 3 of hps_0.f2h_irq0 is that of keys0.irq and of keys1.irq", modules,
                     wires)

    def test_a_module_that_is_not_there(self):
        self.refuses("a connection names nobody.s1, but there is no such module",
                     connections=[("avalon", LW, "nobody.s1", 0x40)])

    def test_names_that_are_none(self):
        self.refuses("sys.qsys:18: the name `a b`, expected letters, digits and _",
                     [("a b", "altera_avalon_pio", {})])
        self.write(odd_hw_tcl="add_interface s avalon end\nadd_interface s conduit end\n",
                   bad_hw_tcl="add_interface s conduit end\nadd_interface_port s 1 export Input\n")
        self.refuses("odd_hw.tcl:2: there are two interfaces s", [("o", "odd", {})])
        self.refuses("bad_hw.tcl:2: the name `1`, expected", [("b", "bad", {})])

    def test_an_unknown_kind(self):
        self.refuses("odd_0 is of the kind odd, which is not known here, and the project has no "
                     "odd_hw.tcl, odd.qsys or module odd", [("odd_0", "odd", {})])

    def test_a_missing_subsystem_that_is_named_after_a_nios(self):
        self.refuses("sub is of the kind nios_system, which is not known here",
                     [("sub", "nios_system", {})])

    def test_a_slave_of_a_stream(self):
        self.write(odd_hw_tcl="set_module_property NAME odd\nadd_interface s avalon_streaming end\n"
                              "add_interface_port s data data Input 8\n",
                   odd_v="module odd(input [7:0] data); endmodule\n")
        self.refuses("the slave a.s is of type avalon_streaming, which is not simulated: expected "
                     "avalon, apb, axi, axi4 or axi4lite", [("a", "odd", {})],
                     [("avalon", LW, "a.s", 0x100)])

    def test_a_nios_without_an_arm(self):
        self.with_leds()
        self.write(sys_qsys=qsys([BASE[0], ("cpu", "altera_nios2_gen2", {})], []))
        self.refused("sys.qsys: cpu is a Nios (altera_nios2_gen2), which cannot be simulated, and "
                     "the system has no ARM (altera_hps)")

    def test_wrong_component_descriptions(self):
        for text, message in (("set_module_property NAME odd\nset_interface_property s a\n",
                               "odd_hw.tcl:2: set_interface_property needs 3 words, has 2"),
                              ("while 1 {}\n", "odd_hw.tcl:1: this is wrong Tcl: "),
                              ("set f [open x]\n", "odd_hw.tcl:1: the command open is not"),
                              ("add_interface s avalon end\nadd_interface_port s a address Input "
                               "WIDTH\n", "odd_hw.tcl: the width of port a is `WIDTH`"),
                              ("set_module_property NAME {odd\n",
                               "odd_hw.tcl:1: this is wrong Tcl: missing close-brace")):
            self.with_leds([("odd_0", "odd", {})], odd_hw_tcl="")
            (self.folder / "odd_hw.tcl").write_text(text)
            self.refused(message, "check", "top.qsf")

    def test_scripts_that_descriptions_share(self):
        self.write(a_hw_tcl="source ports.tcl\nset_module_property NAME a\nadd_ports 9\n",
                   ports_tcl="proc add_ports {bits} {\n    wrong $bits\n}\n")
        self.refuses("a_hw.tcl:3: the command wrong is not one that describes a component",
                     [("a", "a", {})])
        self.write(ports_tcl="\nwrong\n")
        self.refuses("ports.tcl:2: the command wrong is not one that describes a component",
                     [("a", "a", {})])
        self.write(ports_tcl="source ports.tcl\n")
        self.refuses("more than 100 files are sourced; does one source itself?",
                     [("a", "a", {})])
        (self.folder / "ports.tcl").unlink()
        self.refuses("a_hw.tcl:1: there is no file ports.tcl", [("a", "a", {})])

    def test_pins_that_are_assigned_to_the_processor(self):
        self.with_leds(ports=", output [2:0] HPS_DDR3_BA")
        with open(self.folder / "top.qsf", "a") as qsf:
            qsf.write("set_location_assignment PIN_E29 -to HPS_DDR3_BA[0]\n")
        done = self.de1sim("check", "top.qsf")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("E29", done.stdout + done.stderr)

    def test_a_port_that_the_system_has_not(self):
        self.with_leds()
        top = (self.folder / "top.v").read_text()
        (self.folder / "top.v").write_text(top.replace(".leds_export", ".led_export"))
        self.refused("led_export", "check", "top.qsf")


run()
