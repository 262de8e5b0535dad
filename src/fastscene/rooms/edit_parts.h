// What the edit*.cc files share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fastscene/rooms/edit.h"

namespace fastscene::editing {

// A document while it is edited, with its room.
class Editor {
  public:
    Editor(const RoomDocument& document, std::shared_ptr<const FurniturePack> pack, const Run& run);

    void apply(const EditStep& step);
    const RoomDocument& document() const { return result_.document; }
    const DocumentRoom& room() const { return room_; }
    const std::shared_ptr<const FurniturePack>& pack() const { return pack_; }
    const EditResult& result() const { return result_; }

  private:
    void build();
    int index_of(const std::string& id) const;
    std::vector<int> with_riders(const std::vector<int>& roots) const;
    void tell(const std::string& id, const std::string& what);
    void carry(int index, Vec3f position, float yaw, const std::vector<int>& along);
    std::vector<int> seats_at(int table) const;
    void place_one(int index, const std::vector<int>& along, PromptObject wish);
    std::vector<Placed> with_added(const PromptObject& asked, const std::optional<Vec2f>& near) const;
    template <class Change>
    void checked(const Change& change);
    std::vector<Placed> laid_out(const std::vector<Placed>& standing, const PromptObject& wish, const Placed* moving,
                                 const std::optional<Vec2f>& near) const;
    std::string new_id(const std::string& kind) const;

    void take(const std::vector<std::string>& ids);
    void move(const EditStep& step);
    void place(const EditStep& step);
    void add(const EditStep& step);
    void recolor(const EditStep& step);
    void recolor_surface(const EditStep& step, const std::string& said);
    void resize(const EditStep& step);
    void restyle(const std::string& name);
    void light(const std::string& value);

    std::shared_ptr<const FurniturePack> pack_;
    Run run_;
    EditResult result_;
    DocumentRoom room_;
};

// The things that words mean in a room.
std::vector<std::string> named(const RoomDocument& document, const DocumentRoom& room, const std::string& words,
                               const std::shared_ptr<const FurniturePack>& pack);

}  // namespace fastscene::editing
