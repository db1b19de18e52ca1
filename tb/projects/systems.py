"""systems.py - .qsys files of a few lines"""

HPS = {"LWH2F_Enable": "true", "S2F_Width": "2", "F2S_Width": "0", "F2SINTERRUPT_Enable": "true"}
LW, FULL = "hps_0.h2f_lw_axi_master", "hps_0.h2f_axi_master"


def qsys(modules, connections, exports=()):
    text = '<?xml version="1.0"?>\n<system name="$${FILENAME}">\n'
    exports = [("clk", "clk_0.clk_in"), ("reset", "clk_0.clk_in_reset"), *exports]
    for name, internal in exports:
        text += f' <interface name="{name}" internal="{internal}" type="conduit" dir="end" />\n'
    for name, kind, parameters in modules:
        text += f' <module name="{name}" kind="{kind}" version="18.1" enabled="1">\n'
        for parameter, value in parameters.items():
            text += f'  <parameter name="{parameter}" value="{value}" />\n'
        text += " </module>\n"
    for kind, start, end, *number in connections:
        text += f' <connection kind="{kind}" version="18.1" start="{start}" end="{end}">\n'
        name = {"avalon": "baseAddress", "interrupt": "irqNumber"}.get(kind)
        if number:
            text += f'  <parameter name="{name}" value="{number[0]:#x}" />\n'
        text += " </connection>\n"
    return text + "</system>\n"


def pio(name, base, **parameters):
    """An output port of ten bits on the lightweight bridge."""
    return ([(name, "altera_avalon_pio", {"width": "10", "direction": "Output", **parameters})],
            [("clock", "clk_0.clk", f"{name}.clk"), ("reset", "clk_0.clk_reset", f"{name}.reset"),
             ("avalon", LW, f"{name}.s1", base)])
