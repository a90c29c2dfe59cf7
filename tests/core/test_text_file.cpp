// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file.h"
#include "core/text_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace agv;
namespace fs = std::filesystem;

namespace {

/// A fresh folder for every test, gone afterwards.
class TextFile : public testing::Test {
protected:
    TextFile()
    {
        std::string pattern = (fs::temp_directory_path() / "agv-text-file-XXXXXX").string();
        m_folder = ::mkdtemp(pattern.data());
    }
    ~TextFile() override
    {
        fs::permissions(m_folder, fs::perms::owner_all);
        fs::remove_all(m_folder);
    }

    fs::path file(const char* name) const { return m_folder / name; }

    void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

    std::string contentOf(const fs::path& path)
    {
        std::ifstream stream(path);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::size_t filesInFolder() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }

    fs::path m_folder;
};

/// Root may do everything, so a test of permissions that root runs is run as nobody.
class Unprivileged {
public:
    explicit Unprivileged(const fs::path& folder)
    {
        constexpr uid_t nobody = 65534;
        m_wasRoot =
            ::geteuid() == 0 && ::chown(folder.c_str(), nobody, nobody) == 0 && ::seteuid(nobody) == 0;
    }
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;
    ~Unprivileged()
    {
        if (m_wasRoot && ::seteuid(0) != 0)
            ADD_FAILURE() << "cannot become root again";
    }

private:
    bool m_wasRoot = false;
};

/// Makes the disk refuse to hold more than `bytes` of a file, as a full one does.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{bytes, m_before.rlim_max};
        m_handler = ::signal(SIGXFSZ, SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk()
    {
        ::setrlimit(RLIMIT_FSIZE, &m_before);
        ::signal(SIGXFSZ, m_handler);
    }

private:
    rlimit m_before{};
    sighandler_t m_handler = SIG_DFL;
};

} // namespace

TEST_F(TextFile, isReplacedAndKeepsItsPermissions)
{
    put(file("a"), "old");
    fs::permissions(file("a"), fs::perms(0640));
    ASSERT_TRUE(writeTextFile(file("a"), "new"));
    EXPECT_EQ(contentOf(file("a")), "new");
    EXPECT_EQ(fs::status(file("a")).permissions(), fs::perms(0640));
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(TextFile, isMadeWithTheUsualPermissions)
{
    const mode_t before = ::umask(022);
    ASSERT_TRUE(writeTextFile(file("a"), "new"));
    ::umask(before);
    EXPECT_EQ(fs::status(file("a")).permissions(), fs::perms(0644));
}

TEST_F(TextFile, isReplacedBehindASymbolicLink)
{
    put(file("real"), "old");
    fs::create_symlink("real", file("link"));
    ASSERT_TRUE(writeTextFile(file("link"), "new"));
    EXPECT_TRUE(fs::is_symlink(file("link")));
    EXPECT_EQ(contentOf(file("real")), "new");
}

TEST_F(TextFile, isMadeBehindASymbolicLinkThatLeadsNowhereYet)
{
    fs::create_directory(file("folder"));
    fs::create_symlink("../real", file("folder/second"));
    fs::create_symlink("folder/second", file("first"));
    EXPECT_TRUE(checkWritable(file("first")));
    ASSERT_TRUE(writeTextFile(file("first"), "new"));
    EXPECT_TRUE(fs::is_symlink(file("first")));
    EXPECT_TRUE(fs::is_symlink(file("folder/second")));
    EXPECT_EQ(contentOf(file("real")), "new");
}

TEST_F(TextFile, isNotLookedForInACircleOfLinks)
{
    fs::create_symlink("b", file("a"));
    fs::create_symlink("a", file("b"));
    const auto written = writeTextFile(file("a"), "new");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().detail,
              file("a").string() + ": cannot be written: Too many levels of symbolic links");
    EXPECT_TRUE(fs::is_symlink(file("a")));
}

TEST_F(TextFile, goesIntoAPipeWhichStays)
{
    ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
    fs::create_symlink("pipe", file("link"));
    const std::string text(300'000, 'x'); // more than a pipe holds at once
    for (const char* name : {"pipe", "link"}) {
        EXPECT_TRUE(checkWritable(file(name)));
        auto reader = std::async(std::launch::async, [&] { return contentOf(file("pipe")); });
        EXPECT_TRUE(writeTextFile(file(name), text));
        EXPECT_EQ(reader.get(), text) << name;
    }
    EXPECT_TRUE(fs::is_fifo(file("pipe")));
    EXPECT_TRUE(fs::is_symlink(file("link")));
    EXPECT_EQ(filesInFolder(), 2U);
}

TEST_F(TextFile, saysThatThePipesReaderWentAway)
{
    ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
    const auto handler = ::signal(SIGPIPE, SIG_IGN);
    auto reader = std::async(std::launch::async, [&] {
        const int number = ::open(file("pipe").c_str(), O_RDONLY);
        ::close(number);
    });
    const auto written = writeTextFile(file("pipe"), std::string(300'000, 'x'));
    reader.get();
    ::signal(SIGPIPE, handler);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Io);
    EXPECT_EQ(written.error().detail, file("pipe").string() + ": cannot be written: Broken pipe");
    EXPECT_TRUE(fs::is_fifo(file("pipe")));
}

TEST_F(TextFile, goesBehindWhatAnOpenFileHoldsAlready)
{
    put(file("log"), "old, ");
    const int log = ::open(file("log").c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    ASSERT_GE(log, 0);
    const fs::path name = "/proc/self/fd/" + std::to_string(log); // what /dev/stdout is for descriptor 1
    EXPECT_TRUE(checkWritable(name));
    EXPECT_TRUE(writeTextFile(name, "new"));
    EXPECT_EQ(::write(log, ", newer", 7), 7) << "it is still open";
    ::close(log);
    EXPECT_EQ(contentOf(file("log")), "old, new, newer");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(TextFile, isKnownNotToBeWritableBeforeItIsWritten)
{
    EXPECT_EQ(checkWritable(m_folder).error().detail,
              m_folder.string() + ": is a directory; name a file in it");
    EXPECT_EQ(checkWritable(file("none/a")).error().code, ErrorCode::NotFound);
    put(file("a"), "old");
    EXPECT_EQ(checkWritable(file("a/b")).error().code, ErrorCode::NotFound);
    EXPECT_TRUE(checkWritable(file("a")));
    EXPECT_TRUE(checkWritable(file("b")));
    EXPECT_FALSE(fs::exists(file("b")));
    const Unprivileged unprivileged(m_folder);
    fs::permissions(m_folder, fs::perms(0555));
    EXPECT_EQ(checkWritable(file("b")).error().code, ErrorCode::Permission);
}

TEST_F(TextFile, staysAsItWasWhenTheDiskIsFull)
{
    put(file("a"), "old");
    Result<void> written;
    {
        const SmallDisk disk(1000);
        written = writeTextFile(file("a"), std::string(100'000, 'x'));
    }
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Io);
    EXPECT_NE(written.error().detail.find("cannot be written"), std::string::npos);
    EXPECT_EQ(contentOf(file("a")), "old");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(TextFile, staysAsItWasWhenAnEarlierTemporaryFileWasLeftBehind)
{
    put(file("a"), "old");
    put(file("a.AAAAAA"), "left behind");
    ASSERT_TRUE(writeTextFile(file("a"), "new"));
    EXPECT_EQ(contentOf(file("a.AAAAAA")), "left behind");
}

TEST_F(TextFile, saysWhyItCannotBeWritten)
{
    EXPECT_EQ(writeTextFile(m_folder, "x").error().detail,
              m_folder.string() + ": is a directory; name a file in it");
    EXPECT_EQ(writeTextFile(file("none/a"), "x").error().code, ErrorCode::NotFound);
    put(file("a"), "old");
    EXPECT_EQ(writeTextFile(file("a/b"), "x").error().code, ErrorCode::NotFound);
}

TEST_F(TextFile, isNotReplacedWithoutPermission)
{
    const Unprivileged unprivileged(m_folder);
    put(file("a"), "old");
    fs::permissions(file("a"), fs::perms(0444));
    EXPECT_EQ(writeTextFile(file("a"), "new").error().code, ErrorCode::Permission);
    fs::permissions(file("a"), fs::perms(0644));
    fs::permissions(m_folder, fs::perms(0555));
    EXPECT_EQ(writeTextFile(file("a"), "new").error().code, ErrorCode::Permission);
    EXPECT_EQ(contentOf(file("a")), "old");
}

TEST_F(TextFile, saysWhyItCannotBeRead)
{
    EXPECT_EQ(readTextFile(m_folder, 10).error().detail,
              m_folder.string() + ": is a directory; name a file in it");
    const auto absent = readTextFile(file("absent"), 10);
    EXPECT_EQ(absent.error().code, ErrorCode::NotFound);
    EXPECT_EQ(absent.error().detail,
              file("absent").string() + ": cannot be opened: No such file or directory");
    ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
    EXPECT_EQ(readTextFile(file("pipe"), 10).error().detail,
              file("pipe").string() + ": is not a regular file");
    put(file("big"), std::string(3'000'000, 'x'));
    EXPECT_EQ(readTextFile(file("big"), 2'097'152).error().detail,
              file("big").string() + ": is larger than 2 MB; this is hardly the file you meant");
    EXPECT_EQ(readTextFile(file("big"), 3'000'000).value().size(), 3'000'000U);
}

TEST_F(TextFile, isNotReadWithoutPermission)
{
    const Unprivileged unprivileged(m_folder);
    put(file("a"), "x");
    fs::permissions(file("a"), fs::perms::none);
    EXPECT_EQ(readTextFile(file("a"), 10).error().code, ErrorCode::Permission);
}

TEST_F(TextFile, holdsAPlantThatReadsBackFromDisk)
{
    const auto plant = readPlantFile(std::string(AGV_SOURCE_DIR) + "/resources/plant.json").value();
    ASSERT_TRUE(writePlantFile(file("p.json"), plant));
    EXPECT_EQ(readPlantFile(file("p.json")), plant);
}

TEST_F(TextFile, isLeftAloneWhenThePlantIsNotFitToBeWritten)
{
    put(file("p.json"), "old");
    const auto written = writePlantFile(file("p.json"), PlantLayout{});
    ASSERT_FALSE(written);
    EXPECT_TRUE(written.error().detail.starts_with(file("p.json").string() + ": not written; "));
    EXPECT_EQ(contentOf(file("p.json")), "old");
}

TEST_F(TextFile, namesThePathInFrontOfAMistakeInThePlant)
{
    put(file("p.json"), "{");
    EXPECT_EQ(readPlantFile(file("p.json")).error().detail,
              file("p.json").string() +
                  ":1:2: the text ends too early; a bracket, brace or quotation mark is not closed");
}
