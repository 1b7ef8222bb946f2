"""Numbers that neither Python nor mpmath has."""


class Foreign:
    """A number with an arithmetic of its own, which has an elementary function by its name: `called`, with "recip" among them."""

    __slots__ = ()

    def __truediv__(self, other):
        return self * (other.called("recip") if isinstance(other, Foreign) else other**-1)

    def __rtruediv__(self, other):
        return self.called("recip") * other
