// Splats from one file format to another, optionally only the most visible.     convert_splats IN OUT [COUNT]
// The ending of OUT chooses its format: docs/formats.md lists them.
#include <fastscene/splat.h>

#include <iostream>

using namespace fastscene;

int main(int argc, char** argv) try {
    if (argc < 3) throw UsageError("usage: convert_splats IN OUT [COUNT]");
    if (!splat_format_of_name(argv[2]))
        throw UsageError("{}: expected a name that ends in {}", argv[2], splat_endings());

    // The format of the input is told by its first bytes. Files differ in their axes: in memory it is always x right,
    // y down, z forward.
    LoadedSplats loaded = load_splats(argv[1]);
    if (loaded.cleaned.dropped > 0)
        std::cerr << argv[1] << ": " << loaded.cleaned.dropped << " splats with NaN were left out\n";

    // Those that cover most, by opacity and area.
    if (argc > 3) loaded.splats = strongest(loaded.splats, std::stoul(argv[3]));
    save_splats(argv[2], loaded.splats);
    std::cout << loaded.splats.size() << " splats\n";
} catch (const std::exception& e) {  // an Error names the file, what was expected and what was found
    std::cerr << e.what() << '\n';
    return 1;
}
