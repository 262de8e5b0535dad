"""A sentence becomes a room as a document, which is then changed in words.     plan_room.py OUT.json"""
import json
import sys

import fastscene

document = fastscene.plan_document("a cozy bedroom with a red armchair", seed=1)
print(len(document["things"]), "things:", ", ".join(sorted({thing["kind"] for thing in document["things"]})))

document, changes = fastscene.edit_by_sentence(document, "make the armchair green")
for what, change in changes:
    print(what, "-", change)
with open(sys.argv[1], "w", encoding="utf-8") as file:
    json.dump(document, file, indent=2)
