#!/usr/bin/python3
"""Runs $PROGRAM on the machine and samples commands and filtered positions into $SAMPLES: in place of a display."""
import os
import subprocess
import sys
import time

import linuxcnc

command, status = linuxcnc.command(), linuxcnc.stat()


def wait(what, seconds=60):
    end = time.time() + seconds
    while time.time() < end:
        status.poll()
        if what():
            return
        time.sleep(0.02)
    sys.exit("drive.py: nothing happened for too long")


def halcmd(*words):
    subprocess.run(["halcmd", *words], check=True, stdout=subprocess.DEVNULL)


command.state(linuxcnc.STATE_ESTOP_RESET)
command.wait_complete()
command.state(linuxcnc.STATE_ON)
command.wait_complete()
command.mode(linuxcnc.MODE_MANUAL)
command.wait_complete()
command.home(-1)
wait(lambda: sum(status.homed[:3]) == 3)
command.mode(linuxcnc.MODE_AUTO)
command.wait_complete()
command.program_open(os.environ["PROGRAM"])
sampler = subprocess.Popen(["halsampler", os.environ["SAMPLES"]])
halcmd("setp", "sampler.0.enable", "1")
command.auto(linuxcnc.AUTO_RUN, 0)
wait(lambda: status.interp_state != linuxcnc.INTERP_IDLE)
wait(lambda: status.interp_state == linuxcnc.INTERP_IDLE and status.inpos)
time.sleep(0.3)
halcmd("setp", "sampler.0.enable", "0")
time.sleep(0.3)
sampler.terminate()
sampler.wait()
