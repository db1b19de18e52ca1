# scenario_schema_test.py - the JSON Schema and the reader agree about good and bad scenarios
#
# usage: scenario_schema_test.py SCHEMA READ_SCENARIO    (Debian: python3-jsonschema, python3-yaml)
import json
import os
import subprocess
import sys
import tempfile

import jsonschema
import yaml

HEAD = "name: a\nversion: 1\n"

GOOD_FILES = [
    HEAD + "duration: 1s\n",
    HEAD + "seed: 18446744073709551615\nduration: 0.5ms\nsteps: [{delay: 0s}]\n",
    "version: 1\nsteps: [{delay: 3600s}]\nname: 'a: b'\n",
    HEAD + "duration: 1s\nps2: mouse\n", HEAD + "duration: 1s\nps2: [nothing, keyboard]\n",
    HEAD + "duration: 1s\nparts: [{keypad: 'GPIO_1[6:0], GPIO_0[35]'}]\n",
    HEAD + "duration: 1s\nparts: [{keypad: 'ARDUINO_IO[15:9],GPIO_0[35]'}]\n"
           "steps: [{set-pins: {arduino_io: 15, level: low}}]\n",
    HEAD + "duration: 1s\nproject: a/b.qsf\ncpu: arm\nfpga-memory: bridge\naudio-rate: 48000\n",
    HEAD + "duration: 1s\npoints: 3\nvisibility: hidden\n",
    HEAD + "usb: [snes-gamepad, snes-gamepad]\nsteps:\n  - press-pad-button: {button: A, pad: 2}\n",
    HEAD + """parts:
  - button: {name: fire, pin: "GPIO_1[33]", pressed: high}
  - switch: {name: mode, pin: "GPIO_1[35]"}
  - led: {name: heart, pin: "GPIO_1[0]", lit: low}
  - led-matrix: {name: face, rows: "GPIO_1[1:2]", columns: "GPIO_1[7], GPIO_1[9]"}
  - keypad: {pins: "GPIO_1[27:20]"}
  - lt24: GPIO_0
steps:
  - press-button: {button: fire, for: 1s}
  - hold-button: fire
  - release-button: fire
  - set-switch: {switch: mode, level: low}
  - expect-led: {led: heart, equals: dark, timeout: 1s}
  - expect-matrix: {matrix: face, equals: "#.\\n.+"}
  - take-screenshot: {save-to: a.png, of: lt24}
""",
]

GOOD_STEPS = [
    "delay: 500ms", "delay: 1.5s", "delay: 0.001ns",
    "press: {keypad: '5'}", "press: {keypad: 5, for: 80ms}", "press: {keypad: [A, '1', 2]}",
    "press: {key: 0, switch: [0, 9]}", "hold: {key: [0, 1, 2, 3]}", "hold: {switch: 3}",
    "set-voltage: {channel: 0, volts: 0}", "set-voltage: {channel: 7, volts: 4.095}",
    "tilt-board: {right: -30.5}", "tilt-board: {towards: 180}", "accelerate-board: {z: -20}",
    "send-signal: SIGUSR1", "send-signal: {name: SIGKILL, process: 3}",
    "type-keys: 'Hi ~'", "type-keys: \"\\t\\n\"", "type-serial: 'ls -l'", "type-serial: \"\\n\"",
    "press-key: Left", "press-key: 1", "press-key: [Ctrl, c, '/']", "press-key: {key: A, for: 1s}",
    "press-key: {key: A, to: usb}", "type-keys: {text: a, to: usb}", "turn-wheel: {notches: 1}",
    "move-mouse: {right: 1, to: usb}", "plug-usb: gamepad", "unplug-usb: {device: mouse}",
    "plug-usb: {device: snes-gamepad, pad: 2}",
    "hold-key: F12", "hold-key: {key: [Shift, Numpad5]}",
    "press-remote: volume-up", "press-remote: 5", "press-remote: '5'",
    "move-mouse: {right: -5}", "move-mouse: {right: 5, down: 5000, for: 1s}",
    "click-mouse: left", "click-mouse: {button: middle, for: 1s}", "hold-mouse: right",
    "drag-mouse: {down: 1}", "drag-mouse: {down: 1, button: right}", "turn-wheel: -8",
    "press: {key: hps}", "hold: {key: [0, hps]}", "expect-hps-led: lit",
    "expect-hps-led: {equals: dark, timeout: 1s}",
    "set-pins: {jp1: 0, level: low}", "set-pins: {jp1: [0, 31], jp2: 5, level: released}",
    "expect-pins: {jp2: 31, level: high, timeout: 1s}",
    "set-pins: {gpio_0: [0, 35], level: low}", "expect-pins: {gpio_1: 2, level: low}",
    "play-tone: {hz: 440}", "play-tone: {hz: 20, level: 100%, into: microphone}",
    "play-silence: {}", "play-silence: {into: line-in}",
    "wait-frame: 120", "wait-frame: next", "wait-frame: next-swap",
    "wait-frame: {frame: 1, timeout: 2s}",
    "wait-serial: ready", "wait-serial: {text: '42', timeout: 1ns}",
    "expect-tone: {hz: 440}", "expect-tone: {hz: 440.5, within: 0.5%, for: 1s, timeout: 0s}",
    "expect-silence: {for: 100ms}",
    "expect-leds: '0000000101'", "expect-leds: 1023", "expect-leds: {equals: 0, timeout: 1s}",
    "expect-hex: '   100'", "expect-hex: {equals: Error-, timeout: 0s}",
    "take-screenshot: {save-to: a.png}", "take-screenshot: {save-to: a/b..c.png}",
]

BAD_FILES = [
    HEAD + "duration: 1s\nparts: []\n", HEAD + "duration: 1s\nparts: {led: 1}\n",
    HEAD + "duration: 1s\nparts: [{led: {name: a}}]\n",
    HEAD + "duration: 1s\nparts: [{led: {name: a, pin: 'GPIO_0[36]'}}]\n",
    HEAD + "duration: 1s\nparts: [{led: {name: a, pin: 'GPIO_2[3]'}}]\n",
    HEAD + "duration: 1s\nparts: [{led: {name: a, pin: 'ARDUINO_IO[16]'}}]\n",
    HEAD + "duration: 1s\nsteps: [{set-pins: {arduino_io: 16, level: low}}]\n",
    HEAD + "duration: 1s\nparts: [{led: {name: 1, pin: 'GPIO_0[3]'}}]\n",
    HEAD + "duration: 1s\nparts: [{keypad: 'GPIO_0[7;0]'}]\n",
    "", "[]\n", "hello\n", HEAD, "name: a\nduration: 1s\n", "version: 1\nduration: 1s\n",
    "name: a\nversion: 2\nduration: 1s\n", "name: a\nversion: '1'\nduration: 1s\n",
    "name: 5\nversion: 1\nduration: 1s\n", "name: ''\nversion: 1\nduration: 1s\n",
    "name:\nversion: 1\nduration: 1s\n", "name: \"a\\tb\"\nversion: 1\nduration: 1s\n",
    HEAD + "duration: 1s\nseed: -1\n", HEAD + "duration: 1s\nseed: 18446744073709551616\n",
    HEAD + "duration: 1s\nseed: 1.5\n", HEAD + "duration: 0s\n", HEAD + "duration: 1\n",
    HEAD + "duration: 1s\ncolour: red\n", HEAD + "steps: []\n", HEAD + "steps: {delay: 1s}\n",
    HEAD + "duration: 1s\nps2: trackball\n", HEAD + "duration: 1s\nps2: []\n",
    HEAD + "duration: 1s\nps2: [mouse, mouse]\n",
    HEAD + "duration: 1s\nps2: [mouse, keyboard, nothing]\n",
    HEAD + "steps: [delay]\n", HEAD + "steps: [{}]\n",
    HEAD + "steps: [{delay: 1s, hold: {key: 0}}]\n",
]

BAD_STEPS = [
    "type-serial: ''", "type-serial: {}", "type-keys: ''", "type-keys: \"\\e\"",
    "press-button: {}", "set-switch: {switch: mode, level: on}", "expect-led: {led: a}",
    "expect-matrix: {matrix: a, equals: 'ab'}",
    "jump: 1", "delay:", "delay: 500", "delay: -1s", "delay: 1 s", "delay: 1min", "delay: .5s",
    "delay: {time: 1s}", "delay: [1s]",
    "press: 5", "press: {}", "press: {for: 1s}", "press: {keypad: G}", "press: {keypad: a}",
    "press: {keypad: '12'}", "press: {keypad: []}", "press: {keypad: [1, 1]}",
    "press: {key: 4}", "press: {key: '1'}", "press: {switch: 10}", "press: {switch: 1.5}",
    "press: {key: 0, for: 0ms}", "hold: {key: 0, for: 1s}", "release:",
    "send-signal: USR1", "send-signal: 10", "send-signal: {name: SIGHUP, process: 0}",
    "send-signal: {process: 1}",
    "set-voltage: {channel: 8, volts: 1}", "set-voltage: {channel: 0, volts: 5.1}",
    "set-voltage: {channel: 0}", "set-voltage: {volts: 1}", "set-voltage: 1",
    "tilt-board: {right: 181}", "tilt-board: {left: 5}", "accelerate-board: {x: -21}",
    "set-voltage: {channel: 0, volts: -1}", "set-voltage: {channel: 0, volts: '1'}",
    "press-key: '!'", "press-key: left", "press-key: []", "press-key: [Up, Up]", "press-key:",
    "press-key: {for: 1s}", "hold-key: {key: Up, for: 1s}", "press-key: '10'", "press-key: 10",
    "press-remote: up", "press-remote: 10", "press-remote: {for: 1s}", "press-remote:",
    "move-mouse: {}", "move-mouse: {for: 1s}", "move-mouse: {right: 5001}", "move-mouse: 5",
    "move-mouse: {right: 1.5}", "click-mouse: up", "click-mouse: {for: 1s}", "drag-mouse: {}",
    "turn-wheel: 9", "turn-wheel: fast", "press-key: {key: a, to: hand}", "plug-usb: hub",
    "plug-usb: {device: gamepad, pad: 3}",
    "move-stick: left",
    "press-pad-button: C", "move-stick: {right: 5}", "move-stick: {stick: left, right: 101}",
    "press: {key: HPS}", "expect-hps-led: on", "expect-hps-led: {}", "set-pins: {level: low}",
    "set-pins: {gpio_0: 36, level: low}",
    "set-pins: {jp1: 0}", "set-pins: {jp1: 32, level: low}", "set-pins: {jp1: 0, level: 1}",
    "expect-pins: {jp1: 0, level: released}", "expect-pins: {jp1: [], level: low}",
    "show-picture: {}", "show-picture: {picture: a.png}",
    "play-tone: {}", "play-tone: 440", "play-tone: {hz: 440, into: ear}", "play-file: {}",
    "play-file: {file: a.wav, repeat: twice}", "play-silence: ear", "play-silence:",
    "wait-frame: 0", "wait-frame: 1000001", "wait-frame: later", "wait-frame: {timeout: 1s}",
    "wait-frame: {frame: 1, timeout: 0s}", "wait-serial: ''", "wait-serial: 42", "wait-serial: yes",
    "expect-frame: a.png", "expect-frame: {}", "expect-frame: {equals: a, differing-pixels: -1}",
    "expect-frame: {equals: a, differing-pixels: 1310721}",
    "expect-frame: {equals: a, ignore: []}", "expect-frame: {equals: a, ignore: 10x5}",
    "expect-frame: {equals: a, ignore: 0x5+1+1}", "expect-frame: {equals: a, ignore: 1x1-1+1}",
    "expect-frame: {equals: a, ignore: [1x1+0+0, 1x1+0+0]}",
    "expect-tone: 440", "expect-tone: {within: 3%}", "expect-tone: {hz: 19}",
    "expect-tone: {hz: '440'}", "expect-tone: {hz: 440, within: 3}", "expect-silence: {}",
    "expect-silence: 1s", "expect-leds: 1024", "expect-leds: '101'", "expect-leds: '00000001012'",
    "expect-hex: '12345'", "expect-hex: '1234567'", "expect-hex: 123456", "expect-hex: '12345K'",
    "take-screenshot: a.png", "take-screenshot: {save-to: /a.png}",
    "take-screenshot: {save-to: ../a.png}", "take-screenshot: {save-to: a/../b.png}",
    "take-screenshot: {save-to: a.jpg}", "take-screenshot: {save-to: .png}",
]

# Errors that a schema cannot express: files, sums of times, controls that are held, YAML itself.
BAD_FOR_THE_READER_ALONE = [
    HEAD + "steps: [{expect-frame: {equals: missing.png}}]\n",
    HEAD + "steps: [{play-file: missing.wav}]\n",
    HEAD + "steps: [{delay: 3601s}]\n", HEAD + "duration: 1s\nsteps: [{delay: 2s}]\n",
    HEAD + "steps: [{hold: {key: 0}}, {press: {key: 0}}]\n",
    HEAD + "steps: [{release: {key: 0}}]\n",
    HEAD + "duration: 1s\nduration: 2s\n", HEAD + "duration: &a 1s\n",
]


def with_step(step):
    return HEAD + "steps:\n  - " + step + "\n"


def main(schema_file, read_scenario):
    with open(schema_file, encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)

    good = GOOD_FILES + [with_step(step) for step in GOOD_STEPS]
    bad = BAD_FILES + [with_step(step) for step in BAD_STEPS]
    cases = ([(text, True, True) for text in good] + [(text, False, False) for text in bad]
             + [(text, True, False) for text in BAD_FOR_THE_READER_ALONE])
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, (text, _, _) in enumerate(cases):
            files.append(os.path.join(folder, f"{number}.yaml"))
            with open(files[-1], "w", encoding="utf-8") as file:
                file.write(text)
        done = subprocess.run([read_scenario, *files], stdout=subprocess.PIPE, text=True,
                              check=True)
    answers = done.stdout.splitlines()
    assert len(answers) == len(cases), "the reader gave not one line for each file"

    wrong = 0
    for (text, schema_takes, reader_takes), answer in zip(cases, answers):
        errors = [error.message for error in validator.iter_errors(yaml.safe_load(text))]
        for who, takes, expected, said in (("schema", not errors, schema_takes, errors),
                                           ("reader", answer == "ok", reader_takes, answer)):
            if takes != expected:
                wrong += 1
                print(f"the {who} should {'take' if expected else 'refuse'} {text!r}: {said}")
    for form in schema["properties"]["steps"]["items"]["properties"].values():
        assert form.get("description"), "a step without a description"
    print(f"{len(cases)} files, {wrong} wrong answers")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
