"""raywalk doctor: is everything there that a run needs?"""

import typer

from raywalk.checks import Finding, gpu_advice, local_findings, server_findings
from raywalk.cli.session import Settings, connected, results
from raywalk.errors import RaywalkError

MARKS = {"ok": "[green]ok  [/]", "warn": "[yellow]warn[/]", "fail": "[red]fail[/]"}


def doctor(context: typer.Context) -> None:
    """Check the daemon, the device, scene data, Python packages and folders; exits with 1 when something fails."""
    settings: Settings = context.obj
    remote = bool(settings.server or settings.transport)
    findings = local_findings(needs_daemon=not remote)
    if remote or not any(finding.state == "fail" for finding in findings):
        try:
            with connected(context) as client:
                findings += server_findings(client)
        except RaywalkError as error:
            advice = "is the address right and the daemon running?" if remote else gpu_advice(str(error))
            advice = advice or "see the message; try ./run build"
            findings.append(Finding("fail", "daemon", str(error), advice))
    console = results()
    for finding in findings:
        advice = f" → {finding.advice}" if finding.advice else ""
        console.print(f"{MARKS[finding.state]} {finding.what}: {finding.detail}{advice}", soft_wrap=True)
    if any(finding.state == "fail" for finding in findings):
        raise typer.Exit(1)
