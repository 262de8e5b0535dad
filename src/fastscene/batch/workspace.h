// Where a scene is made: in its own folder, or on the node's local disk, to be moved to its folder at the end.
#pragma once

#include <filesystem>

namespace fastscene {

class Workspace {
  public:
    // `scratch` empty: `home` itself. Else a folder below it, with what `home` has of an unfinished scene, or what a
    // killed process left there. Throws Error if it cannot be made.
    Workspace(std::filesystem::path home, const std::filesystem::path& scratch);
    const std::filesystem::path& path() const { return path_; }
    // Moves the scene home, finished or not, so that readers see the old folder or the new one. Throws Error if that
    // fails; the scene stays in the scratch folder.
    void bring_home();

  private:
    std::filesystem::path home_, path_;
};

}  // namespace fastscene
