package require -exact qsys 16.1

set_module_property NAME metronome
set_module_property VERSION 1.0
set_module_property DISPLAY_NAME Metronome
set_module_property EDITABLE true

add_fileset QUARTUS_SYNTH QUARTUS_SYNTH "" ""
set_fileset_property QUARTUS_SYNTH TOP_LEVEL metronome
add_fileset_file metronome.v VERILOG PATH metronome.v TOP_LEVEL_FILE

# By which Linux finds its driver: "lesson,metronome-1.0".
set_module_assignment embeddedsw.dts.group metronome
set_module_assignment embeddedsw.dts.name metronome
set_module_assignment embeddedsw.dts.vendor lesson

add_interface clock clock end
add_interface_port clock clk clk Input 1

add_interface reset reset end
set_interface_property reset associatedClock clock
add_interface_port reset reset reset Input 1

add_interface avalon_slave_0 avalon end
set_interface_property avalon_slave_0 addressUnits WORDS
set_interface_property avalon_slave_0 associatedClock clock
set_interface_property avalon_slave_0 associatedReset reset
set_interface_property avalon_slave_0 readWaitTime 1
add_interface_port avalon_slave_0 address address Input 2
add_interface_port avalon_slave_0 write write Input 1
add_interface_port avalon_slave_0 writedata writedata Input 32
add_interface_port avalon_slave_0 read read Input 1
add_interface_port avalon_slave_0 readdata readdata Output 32

add_interface interrupt_sender interrupt end
set_interface_property interrupt_sender associatedAddressablePoint avalon_slave_0
set_interface_property interrupt_sender associatedClock clock
set_interface_property interrupt_sender associatedReset reset
add_interface_port interrupt_sender irq irq Output 1

add_interface lamps conduit end
set_interface_property lamps associatedClock clock
add_interface_port lamps lamps export Output 10
