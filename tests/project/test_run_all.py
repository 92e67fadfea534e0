"""The counting behind the closing line of `./run test`."""

from tests.run_all import Counts, counts_of, run_stages

REPORT = """<testsuites><testsuite name="s">
<testcase name="good"/>
<testcase name="also good" status="run"/>
<testcase name="bad"><failure message="no"/></testcase>
<testcase name="broken"><error message="no"/></testcase>
<testcase name="left out"><skipped message="no GPU"/></testcase>
<testcase name="DISABLED_one" status="notrun"/>
</testsuite></testsuites>"""


def test_a_report_is_counted(tmp_path):
    (tmp_path / "report.xml").write_text(REPORT)
    assert counts_of(tmp_path / "report.xml", 1) == Counts(passed=2, failed=2, skipped=2)


def test_a_crash_counts_as_a_failure(tmp_path):
    assert counts_of(tmp_path / "none.xml", -11) == Counts(failed=1)
    (tmp_path / "cut.xml").write_text(REPORT[:60])
    assert counts_of(tmp_path / "cut.xml", 1) == Counts(failed=1)


def test_a_program_without_tests_counts_nothing(tmp_path):
    assert counts_of(tmp_path / "none.xml", 0) == Counts()


def test_a_failing_stage_does_not_hide_the_next(capsys):
    stages = [("one", lambda: Counts(failed=1)), ("two", lambda: Counts(passed=3, skipped=1))]
    total = run_stages(stages)
    assert str(total) == "3 passed, 1 failed, 1 skipped"
    said = capsys.readouterr().out
    assert "FAILED" in said and "two: 3 passed" in said
