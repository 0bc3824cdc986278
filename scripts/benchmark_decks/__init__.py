"""Decks of data/benchmarks with a closed form or a published answer, each with its reference and what to measure."""
