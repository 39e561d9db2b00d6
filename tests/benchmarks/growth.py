"""x."""


def run(*, repeats):
    return "", {}
