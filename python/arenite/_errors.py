"""Errors and warnings of the package."""


class Error(ValueError):
    """A value that breaks a rule; the message names the value and the rule."""


class RunError(Error):
    """A run that failed physically; the message names time, place and cause."""


class Warning(UserWarning):
    """Something worth a line although nothing is forbidden."""
