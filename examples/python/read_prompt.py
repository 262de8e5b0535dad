"""What is understood of a sentence.     read_prompt.py ["a sentence"]"""
import sys

import fastscene

sentence = sys.argv[1] if len(sys.argv) > 1 else "a cozy bedroom with a red armchair and a zorblax"
report = fastscene.understand_prompt(sentence)
for fate in ("understood", "approximated"):
    for word in report[fate]:
        print(f"{word['words']}: {word['meaning']}" + (" (approximately)" if fate == "approximated" else ""))
for word in report["not_understood"]:
    print(f"{word}: not understood")
