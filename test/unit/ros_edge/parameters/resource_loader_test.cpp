// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/resource_loader.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "geometry/interruption.h"
#include "model/descriptor.h"
#include "support/scratch_folder.h"

namespace collision_monitor {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// \u00fc in UTF-8, as a part may be called in German.
const std::string kOddName = "my part \xC3\xBC #1.stl";

TEST(ResourceLoader, paths_mayHoldBlanksAndAnyLetter) {
  const test::ScratchFolder folder;
  for (const std::string& name :
       {std::string("plain.stl"), kOddName, std::string("50% a%20b.stl")}) {
    const std::string path = (folder.path() / "odd folder" / name).string();
    write(path, name);
    EXPECT_EQ(makeResourceLoader()(path), name);
  }
}

TEST(ResourceLoader, fileUris_mayHoldEscapesOrTheLettersThemselves) {
  const test::ScratchFolder folder;
  write(folder.path() / kOddName, "here");
  const std::string start = "file://" + folder.path().string() + "/";
  EXPECT_EQ(makeResourceLoader()(start + kOddName), "here");
  EXPECT_EQ(makeResourceLoader()(start + "my%20part%20%C3%BC%20%231.stl"), "here");
}

TEST(ResourceLoader, packages_mayHoldThemToo) {
  const test::ScratchFolder folder;
  const std::filesystem::path package = folder.path() / "my workspace" / "odd_package";
  write(package / "package.xml", "<package><name>odd_package</name></package>");
  write(package / "meshes" / kOddName, "here");
  setenv("ROS_PACKAGE_PATH", package.parent_path().c_str(), 1);
  EXPECT_EQ(makeResourceLoader()("package://odd_package/meshes/" + kOddName), "here");
  EXPECT_EQ(makeResourceLoader()("package://odd_package/meshes/my%20part%20%C3%BC%20%231.stl"),
            "here");
}

TEST(ResourceLoader, whatIsNotThere_isNamed) {
  for (const auto& [uri, part] :
       {std::pair("package://no_such_package/a.stl", "'no_such_package'"),
        std::pair("package:///a.stl", "a slash too many"),
        std::pair("package:/p/a.stl", "fewer slashes than package://PACKAGE/PATH"),
        std::pair("urdf/arm.urdf", "'urdf/arm.urdf' is no absolute path"),
        std::pair("/no such folder/a.stl", "'/no such folder/a.stl' cannot be read")}) {
    try {
      makeResourceLoader()(uri);
      ADD_FAILURE() << uri;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

TEST(ResourceLoader, packageThatIsNotThere_isNamedByTheErrorAlone) {
  testing::internal::CaptureStderr();
  EXPECT_THROW(makeResourceLoader()("package://no_such_package/a.stl"), std::exception);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "rospack has lines of its own";
}

std::string faultOfLoading(const std::string& uri, const LoadRules& rules = {}) {
  try {
    makeResourceLoader(rules)(uri);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no fault";
}

TEST(ResourceLoader, slashBeforeThePackage_isNamed) {
  EXPECT_EQ(faultOfLoading("package:///robot/a.stl"),
            "'package:///robot/a.stl' has a slash too many before the package");
}

TEST(ResourceLoader, fileUris_mayNameThisComputerAndNoOther) {
  const test::ScratchFolder folder;
  const std::string path = (folder.path() / "a.stl").string();
  write(path, "here");
  for (const char* start : {"file://localhost", "file:", "FILE://", "file://127.0.0.1"}) {
    EXPECT_EQ(makeResourceLoader()(start + path), "here") << start;
  }
  EXPECT_NE(faultOfLoading("file://robot" + path).find("the computer 'robot'"), std::string::npos);
  EXPECT_NE(faultOfLoading("file://" + path + "%00").find("%00"), std::string::npos);
}

TEST(ResourceLoader, whatIsNoRegularFile_isRefusedByAnyName) {
  const test::ScratchFolder folder;
  write(folder.path() / "odd_package" / "package.xml",
        "<package><name>odd_package</name></package>");
  const std::string pipe = (folder.path() / "odd_package" / "pipe.stl").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  setenv("ROS_PACKAGE_PATH", folder.path().c_str(), 1);
  for (const std::string& uri :
       {pipe, "file://" + pipe, std::string("package://odd_package/pipe.stl")}) {
    EXPECT_EQ(faultOfLoading(uri), "'" + pipe + "' is a pipe (FIFO), not a regular file");
  }
  EXPECT_EQ(faultOfLoading("file:///dev/zero"), "'/dev/zero' is a device, not a regular file");
}

TEST(ResourceLoader, filesLargerThanTheLimit_areRefused) {
  const test::ScratchFolder folder;
  const std::string path = (folder.path() / "a.stl").string();
  write(path, "12345");
  LoadRules rules;
  rules.max_size = 4;
  EXPECT_NE(faultOfLoading(path, rules).find("larger than the limit of 4 bytes"),
            std::string::npos);
  rules.max_size = 5;
  EXPECT_EQ(faultOfLoading(path, rules), "no fault");
}

TEST(ResourceLoader, otherSchemes_areRefusedUnlessTheyAreAllowed) {
  for (const char* uri :
       {"http://localhost/a.stl", "HTTPS://localhost/a.stl", "ftp://x/y", "model:a"}) {
    EXPECT_NE(faultOfLoading(uri).find("which only the parameter files/schemes"), std::string::npos)
        << uri;
  }
  LoadRules rules;
  rules.schemes = {"http"};
  // Nobody listens there: curl says so.
  EXPECT_NE(faultOfLoading("http://127.0.0.1:1/a.stl", rules).find("http://127.0.0.1:1/a.stl"),
            std::string::npos);
  EXPECT_NE(faultOfLoading("https://127.0.0.1:1/a.stl", rules).find("the scheme 'https'"),
            std::string::npos);
}

/// A server on this computer that takes connections, and says nothing or speaks for ever.
class OddServer {
 public:
  explicit OddServer(bool speaks) : speaks_(speaks) {
    socket_ = Descriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(socket_.get(), reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        listen(socket_.get(), 10) != 0 ||
        getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      throw std::runtime_error("no server");
    }
    root_ = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/";
    thread_ = std::thread([this] { serve(); });
  }
  ~OddServer() {
    shutdown(socket_.get(), SHUT_RDWR);
    thread_.join();
  }

  const std::string& root() const { return root_; }
  int connections() const { return connections_; }

 private:
  void serve() {
    std::vector<Descriptor> open;
    for (;;) {
      open.emplace_back(accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      if (open.back().get() < 0) {
        return;
      }
      ++connections_;
      std::string text = "HTTP/1.0 200 OK\r\n\r\n";
      text.resize(1 << 20, 'x');
      while (speaks_ && send(open.back().get(), text.data(), text.size(), MSG_NOSIGNAL) > 0) {
      }
    }
  }

  bool speaks_;
  Descriptor socket_;
  std::string root_;
  std::atomic<int> connections_{0};
  std::thread thread_;
};

TEST(ResourceLoader, silentServer_isGivenUp_andNotAskedAgain) {
  const OddServer server(false);
  LoadRules rules;
  rules.schemes = {"http"};
  rules.download_time = 0.3;
  const ResourceLoader load = makeResourceLoader(rules);
  for (const std::string name : {"a.stl", "b.stl"}) {
    try {
      load(server.root() + name);
      ADD_FAILURE();
    } catch (const std::runtime_error& fault) {
      EXPECT_NE(std::string(fault.what())
                    .find("a.stl: not read within the limit of 0.3 s (parameter "
                          "files/download_time)"),
                std::string::npos)
          << fault.what();
    }
  }
  EXPECT_EQ(server.connections(), 1);
}

TEST(ResourceLoader, endlessServer_isGivenUp) {
  const OddServer server(true);
  LoadRules rules;
  rules.schemes = {"http"};
  rules.max_size = 1000000;
  EXPECT_NE(
      faultOfLoading(server.root() + "a.stl", rules)
          .find("a.stl: larger than the limit of 1000000 bytes (parameter files/max_size), or "
                "without an end"),
      std::string::npos);
}

TEST(ResourceLoader, downloads_areInterrupted) {
  const OddServer server(false);
  LoadRules rules;
  rules.schemes = {"http"};
  rules.download_time = 600.0;
  const ResourceLoader load = makeResourceLoader(rules);
  const Interruptible interruptible([&] { return server.connections() == 0; });
  EXPECT_THROW(load(server.root() + "a.stl"), Interrupted);
}

}  // namespace
}  // namespace collision_monitor
