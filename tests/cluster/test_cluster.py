# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns on a real Slurm: whatever happens to their tasks, the results are those of one machine, byte by byte."""
import os
import pathlib
import signal
import tempfile
import time
import unittest

from campaign import CONFIG, Campaign, differences, json, run
from cluster import Cluster, processes, until

PROGRAM = os.environ.get("KREISEL", "")
NODES = 3


class OnACluster(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="kreisel-cluster-")))
        os.environ["KREISEL_CACHE"] = ""
        (cls.scratch / "slurm").mkdir()
        cls.cluster = cls.enterClassContext(Cluster(cls.scratch / "slurm", NODES))
        cls.config = cls.scratch / "config.json"
        cls.config.write_text(json.dumps(CONFIG))
        # Slurm looks for limits every 30 s: the other tests run meanwhile.
        cls.limited = cls.campaign("limited", "--time", "1")
        cls.limited.submit("--nodelist=n1")
        cls.limited_program, _ = cls.limited.hold(2)
        cls.one_machine = cls.scratch / "one machine"
        done = run(PROGRAM, "run", cls.config, "-o", cls.one_machine, "-j", "2")
        assert done.returncode == 0, done.stderr

    @classmethod
    def campaign(cls, name, *words):
        return Campaign(cls.cluster, PROGRAM, cls.config, name, *words)

    def setUp(self):
        self.began = time.monotonic()
        self.addCleanup(lambda: print(f"{time.monotonic() - self.began:.1f} s ", end="", flush=True))

    def require_complete(self, campaign):
        self.assertEqual(campaign.wait(), "COMPLETED", campaign.logs())
        self.assertEqual(list(differences(campaign, self.one_machine)), [], campaign.logs())

    def test_an_array_gives_the_results_of_one_machine(self):
        plain = self.campaign("plain", "--cpus", "2").submit()
        self.require_complete(plain)
        again = plain.submit()
        self.require_complete(again)  # nothing was computed once more

    def test_a_killed_task_goes_on_by_itself(self):
        killed = self.campaign("killed").submit()
        os.kill(killed.hold(1)[0], signal.SIGKILL)
        self.require_complete(killed)
        self.assertEqual(killed.restarts(1), 1)

    def test_a_lost_node_does_not_compute_beside_its_successor(self):
        lost = self.campaign("lost").submit("--exclude=n1")
        orphan, _ = lost.hold(3)
        node = self.cluster.say("squeue", "--noheader", "--format=%N", f"--jobs={lost.task(3)}")
        self.cluster.kill_node_daemon(node)
        until(lambda: "the task is not started elsewhere", lambda: lost.restarts(3) == 1, 60)
        self.assertIn(orphan, processes())
        self.cluster.start_node(node)
        self.require_complete(lost)

    def test_a_cancelled_array_is_gone_on_with_when_submitted_again(self):
        cancelled = self.campaign("cancelled").submit("--comment=two words")
        _, shell = cancelled.hold(1)
        cancelled.hold(2)
        os.kill(shell, signal.SIGKILL)  # the whole task: nothing is left that could start it again
        self.cluster.say("scancel", cancelled.task(2))
        self.assertEqual(cancelled.wait(), "FAILED")
        self.assertEqual(cancelled.programs(1), {})
        self.assertEqual([cancelled.state(cancelled.task(part)) for part in (2, 3)], ["CANCELLED", "COMPLETED"])
        self.assertIn("missing: rkmk/", cancelled.log("merge"))
        self.assertIn("go on with: bash ", cancelled.log("merge"))
        self.require_complete(cancelled.submit())

    def test_a_folder_is_submitted_once_at_a_time(self):
        busy = self.campaign("busy").submit("--hold")
        refused = run("bash", busy.folder / "submit.sh", env=self.cluster.environment)
        self.assertEqual(refused.returncode, 3)
        self.assertRegex(refused.stderr, rf"still queued or running: .*\b{busy.references}\b")
        self.cluster.say("scancel", busy.references, busy.parts, busy.merge)

    def test_a_time_limit_is_survived(self):
        self.require_complete(self.limited)
        self.assertEqual([self.limited.restarts(part) for part in (1, 2, 3)], [0, 1, 0])
        said = self.limited.log("part-2")
        self.assertIn("interrupted with", said)
        self.assertIn(f"--max-memory {160 << 20} ", said)  # 80 % of what a job gets here
        self.assertNotIn(self.limited_program, processes())

    @classmethod
    def tearDownClass(cls):
        if os.environ.get("KREISEL_CLUSTER_LOGS"):
            print(cls.cluster.logs())
