#include "base/file.hpp"

#include <gtest/gtest.h>
#if !defined(_WIN32)
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#endif
#include <cstdio>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using mien::testing::read_bytes;
using mien::testing::ScratchFolder;
using mien::testing::write_bytes;

template <typename Call>
Status thrown_status(Call&& call) {
    try {
        call();
        return Status::ok;
    } catch (const Error& error) {
        return error.status();
    }
}

TEST(File, MappingAndReadingGiveTheSameBytes) {
    ScratchFolder folder;
    const std::string path = folder / "\xc3\xa9t\xc3\xa9.bin";
    write_bytes(path, std::string("a\0b", 3));
    const FileBytes mapped = map_file(path), whole = read_whole_file(path, Context());
    EXPECT_EQ(std::string(mapped.data, mapped.size), std::string("a\0b", 3));
    EXPECT_EQ(std::string(whole.data, whole.size), std::string("a\0b", 3));
}

TEST(File, AnEmptyFileHasNoBytes) {
    ScratchFolder folder;
    write_bytes(folder / "empty", "");
    EXPECT_EQ(map_file(folder / "empty").size, 0u);
    EXPECT_EQ(read_whole_file(folder / "empty", Context()).size, 0u);
}

TEST(File, WhatIsNoRegularFileIsRefusedAtOnce) {
    ScratchFolder folder;
    EXPECT_EQ(thrown_status([&] { map_file(folder / "nothing"); }), Status::io);
    EXPECT_EQ(thrown_status([&] { map_file(folder / "."); }), Status::io);
    EXPECT_EQ(thrown_status([&] { map_file(""); }), Status::invalid_argument);
    EXPECT_EQ(thrown_status([&] { map_file(std::string("a\0b", 3)); }), Status::invalid_argument);
    EXPECT_EQ(thrown_status([&] { map_file(std::string(100000, 'a')); }), Status::io);
#if !defined(_WIN32)
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(thrown_status([&] { map_file(folder / "pipe"); }), Status::io);
    EXPECT_EQ(thrown_status([&] { read_whole_file("/dev/zero", Context()); }), Status::io);
#endif
}

TEST(File, ReadingKeepsToTheMemoryBudget) {
    ScratchFolder folder;
    write_bytes(folder / "f", std::string(1000, 'x'));
    Context context;
    context.max_bytes = 999;
    EXPECT_EQ(thrown_status([&] { read_whole_file(folder / "f", context); }),
              Status::memory_budget);
}

TEST(AtomicFile, TakesTheTargetsPlaceOnlyWhenCommitted) {
    ScratchFolder folder;
    const std::string path = folder / "model.bin";
    write_bytes(path, "old");
    {
        AtomicFile file(path);
        file.write("half a new o");
        EXPECT_EQ(read_bytes(path), "old");
    }
    EXPECT_EQ(read_bytes(path), "old");
    EXPECT_EQ(folder.num_entries(), 1u);
    AtomicFile file(path);
    const std::string large(3000000, 'n');
    file.write("new");
    file.write(large);
    file.write("end");
    file.commit();
    EXPECT_EQ(read_bytes(path), "new" + large + "end");
    EXPECT_EQ(folder.num_entries(), 1u);
}

TEST(AtomicFile, RefusesTargetsThatCannotBeFiles) {
    ScratchFolder folder;
    std::filesystem::create_directory(folder / "sub");
    EXPECT_EQ(thrown_status([&] { AtomicFile file(folder / "sub"); }), Status::io);
    EXPECT_EQ(thrown_status([&] { AtomicFile file(folder / "missing/file"); }), Status::io);
    EXPECT_EQ(thrown_status([&] { AtomicFile file(""); }), Status::invalid_argument);
#if !defined(_WIN32)
    EXPECT_EQ(thrown_status([&] { AtomicFile file("/dev/null"); }), Status::io);
    write_bytes(folder / "plain", "x");
    EXPECT_EQ(thrown_status([&] { AtomicFile file(folder / "plain/file"); }), Status::io);
    EXPECT_EQ(read_bytes(folder / "plain"), "x");
#endif
    EXPECT_EQ(folder.num_entries(), 1u + (std::filesystem::exists(folder / "plain") ? 1u : 0u));
}

#if !defined(_WIN32)

// The file size limit stands in for a full disk: both make write() fail after some bytes.
TEST(AtomicFile, AFullDiskLeavesTheOldFileWhole) {
    ScratchFolder folder;
    const std::string path = folder / "model.bin";
    write_bytes(path, "old");
    struct rlimit before;
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    struct rlimit small = before;
    small.rlim_cur = 1 << 20;
    void (*handler)(int) = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Status status = thrown_status([&] {
        AtomicFile file(path);
        file.write(std::string(3 << 20, 'n'));
        file.commit();
    });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(status, Status::io);
    EXPECT_EQ(read_bytes(path), "old");
    EXPECT_EQ(folder.num_entries(), 1u);
}

// Without the guard in AtomicFile the kernel's SIGXFSZ ends the process.
TEST(AtomicFile, AFileBeyondTheProcesssLimitIsAnErrorAndNoSignal) {
    ScratchFolder folder;
    const std::string path = folder / "model.bin";
    const pid_t child = fork();
    if (child == 0) {
        const struct rlimit small = {1 << 20, 1 << 20};
        setrlimit(RLIMIT_FSIZE, &small);
        const Status status = thrown_status([&] {
            AtomicFile file(path);
            file.write(std::string(3 << 20, 'n'));
            file.commit();
        });
        _exit(status == Status::io ? 0 : 1);
    }
    int how = 0;
    ASSERT_EQ(waitpid(child, &how, 0), child);
    EXPECT_TRUE(WIFEXITED(how) && WEXITSTATUS(how) == 0);
    EXPECT_EQ(folder.num_entries(), 0u);
}

/// The number of files after a writer was killed with its bytes written and not yet committed.
std::size_t entries_after_a_kill(const ScratchFolder& folder, const std::string& path) {
    int ready[2];
    EXPECT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        AtomicFile file(path);
        file.write(std::string(3 << 20, 'n'));
        (void)!write(ready[1], "r", 1);
        pause();
    }
    char byte = 0;
    EXPECT_EQ(read(ready[0], &byte, 1), 1);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(ready[0]);
    close(ready[1]);
    return folder.num_entries();
}

TEST(AtomicFile, AKilledWriterLeavesTheOldFileAndTheNextWriterNothingElse) {
    ScratchFolder folder;
    const std::string path = folder / "model.bin";
    write_bytes(path, "old");
    for (int round = 0; round < 5; ++round) EXPECT_LE(entries_after_a_kill(folder, path), 2u);
    EXPECT_EQ(read_bytes(path), "old");
    AtomicFile file(path);
    file.write("new");
    file.commit();
    EXPECT_EQ(read_bytes(path), "new");
    EXPECT_EQ(folder.num_entries(), 1u);
}

/// The name of a target's temporaries, as atomic_file.cpp makes it.
std::string temporary_of(const std::string& name, unsigned slot) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : name) hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x100000001b3u;
    char text[64];
    std::snprintf(text, sizeof text, ".mien-%016llx-%u.tmp", static_cast<unsigned long long>(hash),
                  slot);
    return text;
}

TEST(AtomicFile, RemovesWhatAKilledWriterLeftAndNothingThatIsInUse) {
    ScratchFolder folder;
    write_bytes(folder / temporary_of("model.bin", 0), "abandoned");
    write_bytes(folder / temporary_of("model.bin", 2), "abandoned");
    const std::string held = folder / temporary_of("model.bin", 1),
                      foreign = folder / temporary_of("other.bin", 0);
    write_bytes(held, "in use");
    write_bytes(foreign, "another target's");
    const int descriptor = open(held.c_str(), O_RDONLY);
    ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
    AtomicFile file(folder / "model.bin");
    file.write("new");
    file.commit();
    EXPECT_EQ(read_bytes(held), "in use");
    EXPECT_EQ(read_bytes(foreign), "another target's");
    EXPECT_EQ(read_bytes(folder / "model.bin"), "new");
    EXPECT_EQ(folder.num_entries(), 3u);
    close(descriptor);
}

TEST(AtomicFile, ManyWritersOfOneTargetAtATimeLeaveOneWholeFile) {
    ScratchFolder folder;
    const std::string path = folder / "model.bin";
    std::vector<std::thread> writers;
    for (int k = 0; k < 8; ++k)
        writers.emplace_back([&path, k] {
            for (int round = 0; round < 20; ++round) {
                AtomicFile file(path);
                file.write(std::string(300000, static_cast<char>('a' + k)));
                file.commit();
            }
        });
    for (std::thread& writer : writers) writer.join();
    const std::string bytes = read_bytes(path);
    EXPECT_EQ(bytes, std::string(300000, bytes.at(0)));
    EXPECT_EQ(folder.num_entries(), 1u);
}

TEST(AtomicFile, AReadOnlyFolderIsAnErrorAndStaysAsItIs) {
    ScratchFolder folder;
    ASSERT_EQ(chmod((folder / ".").c_str(), 0555), 0);
    // Root writes to read-only folders, so the superuser becomes somebody else for this.
    const uid_t user = geteuid();
    constexpr uid_t kNobody = 65534;
    ASSERT_TRUE(user != 0 || seteuid(kNobody) == 0);
    const Status status = thrown_status([&] { AtomicFile file(folder / "model.bin"); });
    ASSERT_TRUE(user != 0 || seteuid(user) == 0);
    EXPECT_EQ(status, Status::io);
    EXPECT_EQ(folder.num_entries(), 0u);
    chmod((folder / ".").c_str(), 0700);
}

TEST(AtomicFile, KeepsPermissionsAndFollowsLinks) {
    ScratchFolder folder;
    write_bytes(folder / "real", "old");
    ASSERT_EQ(chmod((folder / "real").c_str(), 0640), 0);
    ASSERT_EQ(symlink("real", (folder / "link").c_str()), 0);
    AtomicFile file(folder / "link");
    file.write("new");
    file.commit();
    EXPECT_EQ(read_bytes(folder / "real"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    struct stat info;
    ASSERT_EQ(stat((folder / "real").c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0640u);
}

#endif

TEST(File, LongPathsKeepTheirEndInMessages) {
    const std::string shown = shown_path(std::string(300, 'd') + "/scan.ply");
    EXPECT_LE(shown.size(), 120u);
    EXPECT_NE(shown.find("/scan.ply"), std::string::npos);
    EXPECT_EQ(shown_path("a\nb"), "a?b");
}

}  // namespace
