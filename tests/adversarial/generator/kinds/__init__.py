"""The kinds of models: each is a function of a random source that gives a `Model`."""

KINDS = {}


def kind(function):
    """Registers a kind under the name of its function; the model is handed in empty."""
    from tree import Model

    def make(rng):
        model = Model(function.__name__)
        function(model, rng)
        return model

    KINDS[function.__name__] = make
    return function


from kinds import (  # noqa: E402, F401
    bodies,
    branches,
    chains,
    constrained,
    corners,
    discontinuous,
    domains,
    energies,
    forces,
    identities,
    ignorable,
    known,
    mechanisms,
    placed,
    steep,
    turning,
    vectors,
    watched,
)
