// Looks: coarse pictures of rooms within seconds, each made by a process of its own. One may be wished for while a
// sentence is still being written; the scene's job finds it done.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "fastscene/studio/board.h"
#include "fastscene/studio/library.h"

namespace fastscene::studio {

class Looks {
  public:
    Looks(Library& library, Board& board, std::filesystem::path program);
    ~Looks();

    // The picture's name for arguments of `panorama`, without those for its size and folder.
    static std::string key_of(const std::vector<std::string>& arguments);
    // A room's document as a file to look at: the same text, the same file.
    std::filesystem::path room_file(std::string_view document) const;
    // Empty while there is none.
    std::filesystem::path picture(const std::string& key) const;

    // Makes it soon, in the background and with low priority; a wish before it is given up.
    void wish(const std::vector<std::string>& arguments);
    // Makes it now, or waits until the wish for the same is fulfilled. A failure is no error here: making the
    // scene will report it. Throws Stopped.
    void make(const std::vector<std::string>& arguments, const std::stop_token& stop);
    // The wish that was fulfilled last.
    std::string latest() const;

  private:
    void work(const std::stop_token& end);
    void run(const std::vector<std::string>& arguments, int niceness, const std::stop_token& stop) const;
    void forget_old() const;

    Library& library_;
    Board& board_;
    std::filesystem::path program_;
    mutable std::mutex mutex_;
    std::condition_variable_any condition_;
    std::optional<std::vector<std::string>> wished_;
    std::string in_work_, latest_;  // keys
    std::stop_source stop_;         // of the wish in work
    std::jthread worker_;
};

}  // namespace fastscene::studio
