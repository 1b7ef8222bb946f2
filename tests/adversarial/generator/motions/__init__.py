"""Motions: what is integrated, from states to ends, beside references that are integrated here."""
