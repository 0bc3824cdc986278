"""The example decks of data/."""
