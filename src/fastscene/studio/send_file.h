// Files over HTTP, for the studio and for `fastscene view`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace httplib {
class Server;
struct Request;
struct Response;
}  // namespace httplib

namespace fastscene::studio {

// The regular file of that name below `root`; none for names with dots in front, backslashes or zeros, and for what
// lies behind a symbolic link.
std::optional<std::filesystem::path> file_below(const std::filesystem::path& root, const std::string& relative);

// Piece by piece, with ETag and this Content-Security-Policy; 404 if it is no file.
void send_file(const httplib::Request& request, httplib::Response& response, const std::filesystem::path& path,
               const char* policy);

// Of all answers: no guessing of types, no frames of others, no referrer.
void set_safe_headers(httplib::Response& response);

// How long and how much a server waits for its clients, so that slow ones and many do not keep others out. To be called
// before it listens.
void limit_clients(httplib::Server& server);

// Whether a request has more ranges than any honest client sends.
bool has_too_many_ranges(const httplib::Request& request);

}  // namespace fastscene::studio
