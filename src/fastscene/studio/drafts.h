// Drafts: edits of a scene's room that are not made into a scene yet. A draft has a revision: who edits an older one is
// told so. It stands in .studio/drafts/NAME.json, with what can be undone.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/rooms/edit.h"
#include "fastscene/studio/library.h"
#include "fastscene/studio/planner.h"

namespace fastscene::studio {

class Drafts {
  public:
    Drafts(Library& library, Planner& planner) : library_(library), planner_(planner) {}

    // {revision, view, changes: [{id, what}], can_undo, can_redo}; revision 0: nothing was changed.
    Json draft(const std::string& scene);
    // The room as the scene has it, without edits (plan_view.h).
    Json scene_view(const std::string& scene);
    // `step`: {op: move|turn|recolor|remove|add|style|time|say|undo|redo|reset, …}. Throws Refusal 409 unless
    // `revision` is the draft's; UsageError and Error as edit_document does.
    Json edit(const std::string& scene, int revision, const Json& step);
    // The edited room as a file for `edit DIR --room FILE`, and what was changed. Throws Refusal 409 as above, or if
    // nothing was.
    struct Made {
        std::filesystem::path room;
        Json changes;
    };
    Made write(const std::string& scene, int revision, const std::string& new_scene);
    // The edited room. Throws Refusal 409 if nothing was edited.
    std::string room(const std::string& scene);
    void drop(const std::string& scene);

  private:
    struct State {
        int revision = 0;
        std::vector<Json> past, future;  // {document, changes}
        Json now;                        // the same; null: as the scene is
    };
    State load(const std::string& scene) const;
    void save(const std::string& scene, const State& state) const;
    RoomDocument document(const std::string& scene, const State& state) const;
    std::shared_ptr<const FurniturePack> pack(const std::string& scene);
    Json answer(const std::string& scene, const State& state);
    std::filesystem::path file(const std::string& scene) const;

    Library& library_;
    Planner& planner_;
    std::mutex mutex_;
};

}  // namespace fastscene::studio
