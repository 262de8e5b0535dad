#include "fastscene/base/data_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "fastscene/base/file.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Sets an environment variable for the duration of a test.
class Environment {
  public:
    Environment(const char* name, const std::string& value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        ::setenv(name, value.c_str(), 1);
    }
    ~Environment() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
    std::optional<std::string> old_;
};

class DataFiles : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "data-files-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root_ = name;
    }
    void TearDown() override { fs::remove_all(root_); }
    void put(const fs::path& file) {
        fs::create_directories((root_ / file).parent_path());
        write_file(root_ / file, "x");
    }
    fs::path root_;
};

TEST_F(DataFiles, TheFolderNamedByTheUserComesFirstThenTheSystems) {
    put("mine/page.html");
    put("a/fastscene/page.html");
    put("b/fastscene/other.html");
    const Environment system("XDG_DATA_DIRS", (root_ / "a").string() + ":" + (root_ / "b").string());
    EXPECT_EQ(find_data("page.html"), root_ / "a/fastscene/page.html");
    const Environment named("FASTSCENE_DATA_DIR", (root_ / "mine").string());
    EXPECT_EQ(find_data("page.html"), root_ / "mine/page.html");
    EXPECT_EQ(find_data("other.html"), root_ / "b/fastscene/other.html");
    EXPECT_EQ(find_data("none.html"), std::nullopt);
}

TEST_F(DataFiles, TheTreeOfTheRunningProgramIsSearched) {
    const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "share/fastscene";
    const std::vector<fs::path> folders = data_folders();
    EXPECT_NE(std::find(folders.begin(), folders.end(), beside), folders.end());
}

}  // namespace
}  // namespace fastscene
