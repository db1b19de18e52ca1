# The processor: which bridges, ports to its SDRAM, interrupts and pins it has.  Its pins and the
# DDR3's are outside of the simulated FPGA, so they are ports alone.
set_module_property NAME altera_hps
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    S2F_Width 2 F2S_Width 2 LWH2F_Enable true F2SDRAM_Type "" F2SDRAM_Width ""
    F2SINTERRUPT_Enable false F2SCLK_COLDRST_Enable false F2SCLK_DBGRST_Enable false
    F2SCLK_WARMRST_Enable false STM_Enable false GP_Enable false
    S2FCLK_COLDRST_Enable false S2FCLK_PENDINGRST_Enable false MPU_EVENTS_Enable true
    BOOTFROMFPGA_Enable false DEBUGAPB_Enable false TPIUFPGA_Enable false CTI_Enable false
    S2FCLK_USER0CLK_Enable false S2FCLK_USER1CLK_Enable false S2FCLK_USER2CLK_Enable false
    MEM_ROW_ADDR_WIDTH 15 MEM_DQ_WIDTH 32 MEM_BANKADDR_WIDTH 3
    GPIO_Enable "" LOANIO_Enable "" DMA_Enable ""
    S2FCLK_USER0CLK_FREQ 100 S2FCLK_USER1CLK_FREQ 100 S2FCLK_USER2CLK_FREQ 100
} { add_parameter $name STRING $value }
foreach n {0 1 2} {  # of the primitive
    add_parameter USER${n}_PERIOD_FS INTEGER 10000000
    set_parameter_property USER${n}_PERIOD_FS HDL_PARAMETER true
}
foreach name {EMAC0 EMAC1 NAND QSPI SDIO USB0 USB1 SPIM0 SPIM1 SPIS0 SPIS1 UART0 UART1
              I2C0 I2C1 I2C2 I2C3 CAN0 CAN1 TRACE} {
    add_parameter ${name}_PinMuxing STRING Unused
    add_parameter ${name}_Mode STRING N/A
}

proc value {name} { return [get_parameter_value $name] }
proc yes {name} { return [string is true -strict [value $name]] }

# A letter for each pin's direction and its name: "o CLK".
proc pins_of {name mode} {
    switch -glob $name {
        EMAC?  { return {o TX_CLK o TXD0 o TXD1 o TXD2 o TXD3 i RXD0 b MDIO o MDC i RX_CTL o TX_CTL
                         i RX_CLK i RXD1 i RXD2 i RXD3} }
        QSPI   {
            set pins {b IO0 b IO1 b IO2 b IO3 o SS0}
            for {set n 1} {$n < [lindex $mode 0]} {incr n} { lappend pins o SS$n }
            return [concat $pins o CLK]
        }
        SDIO   {
            set pins {b CMD b D0 b D1 o CLK b D2 b D3}
            if {[string match *8-bit* $mode]} { set pins [concat $pins b D4 b D5 b D6 b D7] }
            return $pins
        }
        USB?   { return {b D0 b D1 b D2 b D3 b D4 b D5 b D6 b D7 i CLK o STP i DIR i NXT} }
        SPIM?  { return [concat {o CLK o MOSI i MISO o SS0} [expr {
                     [string match *Dual* $mode] ? {o SS1} : {}}]] }
        SPIS?  { return {i CLK i MOSI o MISO i SS0} }
        UART?  { return [concat {i RX o TX} [expr {
                     [string match {No *} $mode] ? {} : {i CTS o RTS}}]] }
        I2C?   { return {b SDA b SCL} }
        CAN?   { return {i RX o TX} }
        TRACE  { return {o CLK o D0 o D1 o D2 o D3 o D4 o D5 o D6 o D7} }
        NAND   { return {o ALE o CE o CLE o RE i RB b DQ0 b DQ1 b DQ2 b DQ3 b DQ4 b DQ5 b DQ6 b DQ7
                         o WP o WE} }
    }
}

proc pin {direction role {width 1}} {
    upvar interface interface
    add_interface_port $interface $role $role \
        [string map {i Input o Output b Bidir} $direction] $width
}

proc hps_io {} {
    set interface hps_io
    add_interface hps_io conduit end
    foreach name {EMAC0 EMAC1 NAND QSPI SDIO USB0 USB1 SPIM0 SPIM1 SPIS0 SPIS1 UART0 UART1
                  I2C0 I2C1 I2C2 I2C3 CAN0 CAN1 TRACE} {
        if {![string match "HPS I/O Set*" [value ${name}_PinMuxing]]} continue
        foreach {direction role} [pins_of $name [value ${name}_Mode]] {
            pin $direction hps_io_[string tolower $name]_inst_$role
        }
    }
    foreach {parameter name} {GPIO_Enable gpio_inst_GPIO LOANIO_Enable gpio_inst_LOANIO} {
        set n 0
        foreach used [split [value $parameter] ,] {
            if {$used eq "Yes"} { pin b hps_io_[format %s%02d $name $n] }
            incr n
        }
    }
}

# Signals of peripherals whose pins are "FPGA": roles of the conduit with their directions, then the
# clocks beside it.
proc peripherals_in_fpga {} {
    foreach name {UART0 UART1 I2C0 I2C1 I2C2 I2C3 SPIM0 SPIM1 SPIS0 SPIS1 CAN0 CAN1} {
        if {[value ${name}_PinMuxing] ne "FPGA"} continue
        set clocks {}
        switch -glob $name {
            UART?  { set roles {cts i dsr i dcd i ri i dtr o rts o out1_n o out2_n o rxd i txd o} }
            I2C?   { set roles {out_data o sda i}; set clocks {scl_in i clk o} }
            SPIM?  { set roles {txd o rxd i ss_in_n i ssi_oe_n o ss_0_n o ss_1_n o ss_2_n o ss_3_n o}
                     set clocks {sclk_out o} }
            SPIS?  { set roles {txd o rxd i ss_in_n i ssi_oe_n o}; set clocks {sclk_in i} }
            CAN?   { set roles {rxd i txd o} }
        }
        set interface [string tolower $name]
        add_interface $interface conduit end
        foreach {role direction} $roles {
            add_interface_port $interface ${interface}_$role $role \
                [string map {i Input o Output} $direction] 1
        }
        foreach {role direction} $clocks {
            add_interface ${interface}_$role clock [expr {$direction eq "o" ? "start" : "end"}]
            add_interface_port ${interface}_$role ${interface}_${role}_clk clk \
                [string map {i Input o Output} $direction] 1
        }
    }
}

# Those of Ethernet, which rest.
proc ethernet_in_fpga {} {
    set any false
    foreach name {emac0 emac1} {
        if {[value [string toupper $name]_PinMuxing] ne "FPGA"} continue
        set any true
        add_interface $name conduit end
        foreach {role direction bits} {
            phy_txd_o Output 8 phy_txen_o Output 1 phy_txer_o Output 1 phy_rxdv_i Input 1
            phy_rxer_i Input 1 phy_rxd_i Input 8 phy_col_i Input 1 phy_crs_i Input 1
            gmii_mdo_o Output 1 gmii_mdo_o_e Output 1 gmii_mdi_i Input 1 ptp_pps_o Output 1
            ptp_aux_ts_trig_i Input 1
        } { add_interface_port $name ${name}_$role $role $direction $bits }
        foreach {clock end direction} {md_clk start Output gtx_clk start Output
                                       rx_clk_in end Input tx_clk_in end Input} {
            add_interface ${name}_$clock clock $end
            add_interface_port ${name}_$clock ${name}_${clock}_clk clk $direction 1
        }
        foreach which {rx tx} { reset ${name}_${which}_reset Output }
    }
    if {!$any} return
    add_interface emac_ptp_ref_clock clock end
    add_interface_port emac_ptp_ref_clock emac_ptp_ref_clk clk Input 1
}

# Pins of the processor's that the FPGA has; LOANED is the primitive's.
proc loan_io {} {
    if {[string first Yes [value LOANIO_Enable]] < 0} return
    add_interface h2f_loan_io conduit end
    foreach {role direction} {in Output out Input oe Input} {
        add_interface_port h2f_loan_io h2f_loan_io_$role $role $direction 67
    }
    set bits ""
    foreach used [split [value LOANIO_Enable] ,] { set bits [expr {$used eq "Yes"}]$bits }
    set_interface_property h2f_loan_io loaned "71'b$bits"
}

# Requests to its DMA controller.
proc dma_requests {} {
    set n 0
    foreach used [split [value DMA_Enable] ,] {
        set name f2h_dma_req$n
        incr n
        if {$used ne "Yes"} continue
        add_interface $name conduit end
        foreach {role direction} {req Input single Input ack Output} {
            add_interface_port $name ${name}_$role dma_$role $direction 1
        }
    }
}

# Signals that nobody uses in the simulation: role, direction, bits.
proc signals_alone {} {
    foreach {parameter interface prefix ports} {
        STM_Enable f2h_stm_hw_events f2h_ {stm_hwevents i 28}
        MPU_EVENTS_Enable h2f_mpu_events h2f_mpu_
            {eventi i 1 evento o 1 standbywfe o 2 standbywfi o 2}
        BOOTFROMFPGA_Enable f2h_boot_from_fpga f2h_
            {boot_from_fpga_ready i 1 boot_from_fpga_on_failure i 1}
        DEBUGAPB_Enable h2f_debug_apb h2f_dbg_apb_
            {paddr o 18 paddr31 o 1 penable o 1 prdata i 32 pready i 1 psel o 1 pslverr i 1
             pwdata o 32 pwrite o 1}
        DEBUGAPB_Enable h2f_debug_apb_sideband h2f_dbg_apb_ {pclken i 1 dbg_apb_disable i 1}
        TPIUFPGA_Enable h2f_tpiu h2f_tpiu_ {clk_ctl i 1 data o 32}
        CTI_Enable h2f_cti h2f_cti_
            {trig_in i 8 trig_in_ack o 8 trig_out o 8 trig_out_ack i 8 asicctl o 8 fpga_clk_en i 1}
    } {
        if {![yes $parameter]} continue
        add_interface $interface conduit end
        foreach {role direction bits} $ports {
            add_interface_port $interface $prefix$role $role \
                [string map {i Input o Output} $direction] $bits
        }
    }
    foreach {parameter name} {DEBUGAPB_Enable h2f_debug_apb TPIUFPGA_Enable h2f_tpiu
                              CTI_Enable h2f_cti} {
        if {[yes $parameter] && $name ne "h2f_tpiu"} { clock $name }
        if {[yes $parameter] && $name eq "h2f_tpiu"} {
            add_interface h2f_tpiu_clock clock start
            add_interface_port h2f_tpiu_clock h2f_tpiu_clk clk Output 1
        }
    }
    if {[yes DEBUGAPB_Enable]} { reset h2f_debug_apb_reset Output }
}

proc memory {} {
    set interface memory
    add_interface memory conduit end
    set bytes [expr {[value MEM_DQ_WIDTH] / 8}]
    pin o mem_a [value MEM_ROW_ADDR_WIDTH]
    pin o mem_ba [value MEM_BANKADDR_WIDTH]
    foreach role {ck ck_n cke cs_n ras_n cas_n we_n reset_n} { pin o mem_$role }
    pin b mem_dq [value MEM_DQ_WIDTH]
    pin b mem_dqs $bytes
    pin b mem_dqs_n $bytes
    pin o mem_odt
    pin o mem_dm $bytes
    pin i oct_rzqin
}

proc reset {name direction} {
    add_interface $name reset [expr {$direction eq "Output" ? "start" : "end"}]
    set port ${name}_n
    if {$name eq "h2f_reset"} { set port h2f_rst_n }
    if {$name eq "h2f_cold_reset"} { set port h2f_cold_rst_n }
    add_interface_port $name $port reset_n $direction 1
}

proc clock {name} {
    add_interface ${name}_clock clock end
    add_interface_port ${name}_clock ${name}_clk clk Input 1
}

proc bridge {name width address} {
    clock $name
    add_interface ${name}_master avalon start
    set_interface_property ${name}_master associatedClock ${name}_clock
    set_interface_property ${name}_master dataWidth $width
    set_interface_property ${name}_master addressWidth $address
}

# An AXI3 slave's ports, with this before their names.
proc axi_ports {interface prefix width user} {
    foreach {direction roles} [list \
        Input  [list awid 8 awaddr 32 awlen 4 awsize 3 awburst 2 awlock 2 awcache 4 awprot 3 \
                     awvalid 1 wid 8 wdata $width wstrb [expr {$width / 8}] wlast 1 wvalid 1 bready 1 \
                     arid 8 araddr 32 arlen 4 arsize 3 arburst 2 arlock 2 arcache 4 arprot 3 \
                     arvalid 1 rready 1] \
        Output {awready 1 wready 1 bid 8 bresp 2 bvalid 1 arready 1} \
        Output [list rid 8 rdata $width rresp 2 rlast 1 rvalid 1]] {
        foreach {role bits} $roles {
            add_interface_port $interface $prefix[string toupper $role] $role $direction $bits
        }
    }
    if {!$user} return
    foreach role {awuser aruser} {
        add_interface_port $interface $prefix[string toupper $role] $role Input 5
    }
}

# Words of the bus, in all of the processor's 4 GB.
proc avalon_ports {interface prefix width kind} {
    set bytes [expr {$width / 8}]
    set address [expr {$width == 32 ? 30 : $width == 64 ? 29 : $width == 128 ? 28 : 27}]
    foreach {role direction bits} [list address Input $address burstcount Input 8 \
                                        waitrequest Output 1] {
        add_interface_port $interface $prefix[string toupper $role] $role $direction $bits
    }
    if {$kind ne "Write-Only"} {
        foreach {role direction bits} [list readdata Output $width readdatavalid Output 1 \
                                            read Input 1] {
            add_interface_port $interface $prefix[string toupper $role] $role $direction $bits
        }
    }
    if {$kind ne "Read-Only"} {
        foreach {role direction bits} [list writedata Input $width byteenable Input $bytes \
                                            write Input 1] {
            add_interface_port $interface $prefix[string toupper $role] $role $direction $bits
        }
    }
}

# The ports to the SDRAM: lists of kinds and widths.  AXI takes two of the six command ports, one
# for each direction; commandPort is the first, as de1sim_hps_memory.vh numbers them.
proc sdram_ports {} {
    set kinds [regexp -all -inline {AXI-3|Bidirectional|Read-Only|Write-Only} [value F2SDRAM_Type]]
    set widths [regexp -all -inline {\d+} [value F2SDRAM_Width]]
    set n 0
    set command 0
    foreach kind $kinds width $widths {
        set name f2h_sdram$n
        clock $name
        if {$kind eq "AXI-3"} {
            add_interface ${name}_data axi end
            axi_ports ${name}_data ${name}_ $width false
        } else {
            add_interface ${name}_data avalon end
            avalon_ports ${name}_data ${name}_ $width $kind
        }
        set_interface_property ${name}_data associatedClock ${name}_clock
        set_interface_property ${name}_data commandPort $command
        incr n
        incr command [expr {$kind eq "AXI-3" ? 2 : 1}]
    }
}

proc elaborate {} {
    memory
    hps_io
    loan_io
    peripherals_in_fpga
    ethernet_in_fpga
    dma_requests
    reset h2f_reset Output
    if {[yes S2FCLK_COLDRST_Enable]} { reset h2f_cold_reset Output }
    if {[yes S2FCLK_PENDINGRST_Enable]} {
        add_interface h2f_warm_reset_handshake conduit end
        foreach {port direction} {h2f_pending_rst_req_n Output f2h_pending_rst_ack_n Input} {
            add_interface_port h2f_warm_reset_handshake $port $port $direction 1
        }
    }
    foreach {parameter name} {F2SCLK_COLDRST_Enable f2h_cold_reset_req
                              F2SCLK_DBGRST_Enable f2h_debug_reset_req
                              F2SCLK_WARMRST_Enable f2h_warm_reset_req} {
        if {[yes $parameter]} { reset $name Input }
    }
    foreach n {0 1 2} {
        if {![yes S2FCLK_USER${n}CLK_Enable]} continue
        set mhz [value S2FCLK_USER${n}CLK_FREQ]
        if {![string is double -strict $mhz] || $mhz < 1 || $mhz > 500} {
            send_message error "S2FCLK_USER${n}CLK_FREQ is $mhz, expected 1 to 500 MHz"
        }
        set_parameter_value USER${n}_PERIOD_FS [expr {int(round(1e9 / $mhz))}]
        add_interface h2f_user${n}_clock clock start
        add_interface_port h2f_user${n}_clock h2f_user${n}_clk clk Output 1
    }
    set widths {"" 32 64 128}
    if {[value S2F_Width] > 0} { bridge h2f_axi [lindex $widths [value S2F_Width]] 30 }
    if {[yes LWH2F_Enable]} { bridge h2f_lw_axi 32 21 }
    if {[value F2S_Width] > 0} {
        clock f2h_axi
        add_interface f2h_axi_slave axi end
        axi_ports f2h_axi_slave f2h_ [lindex $widths [value F2S_Width]] true
        set_interface_property f2h_axi_slave associatedClock f2h_axi_clock
        set_interface_property f2h_axi_slave commandPort 6
    }
    sdram_ports
    signals_alone
    if {[yes GP_Enable]} {
        add_interface h2f_gp conduit end
        add_interface_port h2f_gp h2f_gp_in gp_in Input 32
        add_interface_port h2f_gp h2f_gp_out gp_out Output 32
    }
    if {[yes F2SINTERRUPT_Enable]} {
        foreach n {0 1} {
            add_interface f2h_irq$n interrupt start
            add_interface_port f2h_irq$n f2h_irq_p$n irq Input 32
        }
    }
}
