// HTTP for the studio: access control, files, the stream of events. The Api answers the requests.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "fastscene/studio/api.h"

namespace fastscene::studio {

struct WebParams {
    std::filesystem::path pages;  // the folder of index.html
    std::string host = "127.0.0.1";
    int port = 8420;                                 // 0: any free one
    std::string token;                               // needed from every browser; empty: only this machine may ask
    std::filesystem::path tls_certificate, tls_key;  // PEM; empty: plain HTTP
};

// Serves until `stop`; calls `ready` with the address once it listens. Throws Error if it cannot listen there.
void serve(Api& api, Library& library, const Board& board, const WebParams& params, std::stop_token stop,
           const std::function<void(const std::string& address)>& ready);

}  // namespace fastscene::studio
