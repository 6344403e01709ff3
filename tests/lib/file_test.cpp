// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include <nodal/error.h>
#include <nodal/file.h>

#include "../support/messages.h"
#include "../support/temporary_directory.h"

namespace nodal {
namespace {

namespace fs = std::filesystem;
using toy::message_of;

class File : public testing::Test {
 protected:
  std::string content(const fs::path& path) const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string refusal(const fs::path& path) const {
    return message_of([&] { (void)read_file(path, "table"); });
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder()), fs::directory_iterator()));
  }
  const fs::path& folder() const { return temporary_.path(); }

 private:
  toy::TemporaryDirectory temporary_;
};

TEST_F(File, IsReadWholeWithEveryByte) {
  const std::string all = std::string("a\r\n\0b\xff", 6) + std::string(200000, 'x');
  replace_file(folder() / "f", all);
  EXPECT_EQ(read_file(folder() / "f", "table"), all);
  replace_file(folder() / "f", "");
  EXPECT_EQ(read_file(folder() / "f", "table"), "");
}

TEST_F(File, ThatIsMissingOrAFolderIsRefusedByName) {
  const std::string f = (folder() / "f").string();
  EXPECT_EQ(refusal(f), "cannot read table '" + f + "': No such file or directory");
  EXPECT_EQ(refusal(folder()), "cannot read table '" + folder().string() + "': Is a directory");
  EXPECT_EQ(message_of([&] { (void)read_file(f, ""); }), "cannot read '" + f + "': No such file or directory");
}

// Each of these would wait, or fill the memory, without end.
TEST_F(File, ThatIsNoRegularOneIsRefusedAtOnce) {
  const fs::path fifo = folder() / "fifo", link = folder() / "link";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", link);
  for (const fs::path& path : {fifo, link, fs::path("/dev/zero"), fs::path("/dev/null")})
    EXPECT_EQ(refusal(path),
              "cannot read table '" + path.string() + "': not a regular file; copy its content into one");
}

TEST_F(File, LargerThanALimitIsRefused) {
  replace_file(folder() / "f", std::string(1000, 'x'));
  EXPECT_EQ(read_file(folder() / "f", "table", 1000).size(), 1000u);
  const std::string message = message_of([&] { (void)read_file(folder() / "f", "table", 999); });
  EXPECT_NE(message.find("it is larger than"), std::string::npos) << message;
}

TEST_F(File, IsReplacedWithItsPermissionsAndThroughLinks) {
  const fs::path file = folder() / "f", link = folder() / "link", dangling = folder() / "dangling";
  replace_file(file, "old");
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  fs::create_symlink("f", link);
  replace_file(link, "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content(file), "new");
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
  fs::create_symlink("made", dangling);
  replace_file(dangling, "x");
  EXPECT_TRUE(fs::is_symlink(dangling));
  EXPECT_EQ(content(folder() / "made"), "x");
  EXPECT_EQ(files(), 4u);
}

TEST_F(File, OnAFullDiskKeepsWhatItHeld) {
  // No full disk is at hand, but a limit on the size of files says the same at the same place.
  const auto replace_beyond_the_limit = [this] {
    replace_file(folder() / "f", "old");
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    limit.rlim_cur = limit.rlim_max = 4096;
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) std::exit(2);
    const std::string message = message_of<StoreError>([&] { replace_file(folder() / "f", std::string(8192, 'x')); });
    const bool said = message.find("File too large") != std::string::npos;
    std::exit(said && content(folder() / "f") == "old" && files() == 1 ? 0 : 1);
  };
  EXPECT_EXIT(replace_beyond_the_limit(), testing::ExitedWithCode(0), "");
}

TEST_F(File, ThatIsADeviceIsWrittenToAndStaysOne) {
  replace_file("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const std::string message = message_of<StoreError>([] { replace_file("/dev/full", "text"); });
  EXPECT_TRUE(message.starts_with("cannot write '/dev/full': No space left on device")) << message;
}

// What is asked before the work is what happens after it.
TEST_F(File, ThatCantBeReplacedIsKnownBefore) {
  const fs::path file = folder() / "f", chain = folder() / "chain", loop = folder() / "loop";
  replace_file(file, "old");
  EXPECT_EQ(replace_refusal(file), "");
  EXPECT_EQ(replace_refusal("/dev/null"), "");
  EXPECT_EQ(replace_refusal(folder()), "it is a folder");
  int ends[2];  // an open pipe, as a shell's >(command) gives it: its link leads to no file
  ASSERT_EQ(::pipe(ends), 0);
  const std::string pipe = "/dev/fd/" + std::to_string(ends[1]);
  EXPECT_EQ(replace_refusal(pipe), "");
  replace_file(pipe, "x");
  char got = 0;
  EXPECT_EQ(::read(ends[0], &got, 1), 1);
  EXPECT_EQ(got, 'x');
  for (const int end : ends) ::close(end);
  EXPECT_EQ(replace_refusal(folder() / "none" / "f"), "there is no folder '" + (folder() / "none").string() + "'");
  // Links to links: the last one's target is made, wherever it lies.
  fs::create_directory(folder() / "deep");
  fs::create_symlink("deep/link", chain);
  fs::create_symlink("made", folder() / "deep" / "link");
  EXPECT_EQ(replace_refusal(chain), "");
  replace_file(chain, "x");
  EXPECT_EQ(content(folder() / "deep" / "made"), "x");
  EXPECT_TRUE(fs::is_symlink(folder() / "deep" / "link"));
  fs::create_symlink("loop", loop);
  EXPECT_EQ(replace_refusal(loop), "Too many levels of symbolic links");
  EXPECT_TRUE(message_of<StoreError>([&] {
                replace_file(loop, "x");
              }).starts_with("cannot write '" + loop.string() + "': Too many levels of symbolic links"));
  fs::create_symlink("gone/f", folder() / "lost");
  EXPECT_EQ(replace_refusal(folder() / "lost"), "there is no folder '" + (folder() / "gone").string() + "'");
}

// A pipe that is full and does not wait: the writer does, until a reader comes.
TEST_F(File, IsWrittenWholeToAPipeThatDoesNotWait) {
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
  const std::string text(300000, 'x');
  std::string got;
  std::thread reader([&] {
    char buffer[4096];
    while (got.size() < text.size()) {
      const ssize_t size = ::read(ends[0], buffer, sizeof buffer);
      if (size > 0) got.append(buffer, static_cast<std::size_t>(size));
    }
  });
  EXPECT_EQ(write_all(ends[1], text), 0);
  reader.join();
  EXPECT_EQ(got, text);
  for (const int end : ends) ::close(end);
  EXPECT_EQ(write_all(ends[1], text), EBADF);
}

TEST(Extension, IsTheSameInCapitals) {
  EXPECT_EQ(extension_of("a/Fitted.JSON"), ".json");
  EXPECT_EQ(extension_of("fitted.tar.Gz"), ".gz");
  EXPECT_EQ(extension_of("fitted"), "");
}

TEST_F(File, OfADirectoryThatMayBeAnybodysReplacesLinksAndNothingElse) {
  const fs::path victim = folder() / "victim", link = folder() / "link", fifo = folder() / "fifo";
  replace_file(victim, "mine");
  fs::create_symlink("victim", link);
  replace_file(link, "page", Links::replace);
  EXPECT_FALSE(fs::is_symlink(link));
  EXPECT_EQ(content(link), "page");
  EXPECT_EQ(content(victim), "mine");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_EQ(message_of<StoreError>([&] { replace_file(fifo, "page", Links::replace); }),
            "cannot write '" + fifo.string() + "': it is no regular file; remove it");
}

TEST_F(File, ThatIsAPipeWithoutAReaderIsNotWaitedFor) {
  const fs::path fifo = folder() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string message = message_of<StoreError>([&] { replace_file(fifo, "text"); });
  EXPECT_TRUE(message.starts_with("cannot write '" + fifo.string() + "': ")) << message;
}

TEST_F(File, InAFolderThatIsNotThereIsRefused) {
  const std::string path = (folder() / "none" / "f").string();
  const std::string message = message_of<StoreError>([&] { replace_file(path, "text"); });
  EXPECT_TRUE(message.starts_with("cannot write '" + path + "': No such file or directory")) << message;
}

}  // namespace
}  // namespace nodal
