set_module_property NAME altera_avalon_mailbox_simple
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_mailbox_simple
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name mailbox
set_module_assignment embeddedsw.dts.group mailbox
set_module_assignment embeddedsw.dts.compatible altr,mailbox-1.0

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface rst_n reset end
set_interface_property rst_n associatedClock clk
add_interface_port rst_n rst_n reset_n Input 1
foreach {slave prefix interrupt port} {
    avmm_msg_sender snd interrupt_space space_irq
    avmm_msg_receiver rcv interrupt_msg message_irq
} {
    add_interface $slave avalon end
    foreach {property value} {associatedClock clk associatedReset rst_n readWaitTime 0} {
        set_interface_property $slave $property $value
    }
    foreach {role direction bits} {
        address Input 2 read Input 1 write Input 1 writedata Input 32 readdata Output 32
    } { add_interface_port $slave ${prefix}_$role $role $direction $bits }
    add_interface $interrupt interrupt end
    set_interface_property $interrupt associatedAddressablePoint $slave
    add_interface_port $interrupt $port irq Output 1
}
