# boot.cmd - U-Boot: the FPGA from the SD card, then collide.elf, or on to Linux where there is none
if fatload mmc 0:1 ${loadaddr} de1_soc.rbf && fpga load 0 ${loadaddr} ${filesize}; then
    bridge enable || run bridge_enable_handoff
    if itest.l *0xff202040 == 0x44453153; then
        echo "de1sim: FPGA loaded, system ID ok"
        if fatload mmc 0:1 0x02000000 collide.elf; then
            bootelf 0x02000000
        fi
    else
        echo "de1sim: wrong system ID: de1_soc.rbf is not this project's"
    fi
else
    echo "de1sim: the FPGA is not loaded: is de1_soc.rbf on the card, is MSEL 01010?"
fi
