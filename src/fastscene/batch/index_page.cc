#include "fastscene/batch/index_page.h"

#include <algorithm>

#include "fastscene/base/file.h"

namespace fastscene {
namespace {

// Scenes are JSON; a page's script shows them, some at a time. No text of a prompt becomes markup.
constexpr const char* kPage = R"page(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Scenes</title><style>
:root { color-scheme: light dark; font: 15px/1.4 system-ui, sans-serif; }
body { margin: 1.5rem; } header { display: flex; gap: 1rem; align-items: baseline; flex-wrap: wrap; }
input { font: inherit; padding: .3rem .6rem; min-width: 20rem; } h1 { font-size: 1.3rem; margin: 0; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; margin-top: 1rem; }
figure { margin: 0; } img, .none { width: 100%; aspect-ratio: 16 / 9; object-fit: cover; border-radius: 6px; display: block;
  background: #8883; } .none { display: grid; place-items: center; padding: .5rem; box-sizing: border-box; color: #c33; }
figcaption { margin-top: .3rem; } small { opacity: .7; }
</style></head><body><header><h1>Scenes</h1><label>Search <input id="search" type="search"></label>
<span id="count" role="status"></span></header><main id="scenes"></main>
<script id="data" type="application/json">)page";
constexpr const char* kScript = R"page(</script><script>
const scenes = JSON.parse(document.getElementById('data').textContent), page = 60;
const list = document.getElementById('scenes'), count = document.getElementById('count');
let shown = [], next = 0;
function figure(s) {
  const f = document.createElement('figure'), c = document.createElement('figcaption');
  const link = document.createElement('a');
  if (s.done) {
    link.href = encodeURIComponent(s.name) + '/viewer.html';
    const i = document.createElement('img');
    i.loading = 'lazy'; i.alt = s.prompt; i.src = encodeURIComponent(s.name) + '/preview.jpg';
    i.onerror = () => { i.onerror = null; i.src = link.href = encodeURIComponent(s.name) + '/panorama/color.png'; };
    link.append(i);
  } else {
    const d = document.createElement('div');
    d.className = 'none'; d.textContent = s.error;
    link.href = encodeURIComponent(s.name) + '.log';
    link.append(d);
  }
  const small = document.createElement('small');
  small.textContent = ` ${s.name} · ${Math.round(s.seconds)} s`;
  c.append(s.prompt, document.createElement('br'), small);
  f.append(link, c);
  return f;
}
function more() {
  for (const end = Math.min(next + page, shown.length); next < end; ++next) list.append(figure(shown[next]));
}
function search(words) {
  const all = words.toLowerCase().split(/\s+/).filter(Boolean);
  shown = scenes.filter(s => all.every(w => (s.prompt + ' ' + s.name + (s.done ? '' : ' failed')).toLowerCase().includes(w)));
  count.textContent = `${shown.length} of ${scenes.length}, ${scenes.filter(s => !s.done).length} failed`;
  list.replaceChildren(); next = 0; more();
}
document.getElementById('search').oninput = e => search(e.target.value);
addEventListener('scroll', () => { if (innerHeight + scrollY > document.body.scrollHeight - 900) more(); });
search('');
</script></body></html>
)page";

}  // namespace

void save_index(const std::vector<BatchRecord>& records, const std::filesystem::path& folder) {
    std::vector<BatchRecord> sorted = records;  // as in the list; they end in any order
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    Json scenes = Json::array();
    for (const BatchRecord& r : sorted)
        scenes.push_back(
            {{"name", r.name}, {"prompt", r.prompt}, {"done", r.done}, {"seconds", r.seconds}, {"error", r.error}});
    std::string data = scenes.dump(-1, ' ', false, Json::error_handler_t::replace), safe;
    for (const char c : data) safe += c == '<' ? "\\u003c" : std::string(1, c);  // "</script>" in a prompt
    write_file(folder / "index.html", std::string_view(kPage + safe + kScript));
}

}  // namespace fastscene
