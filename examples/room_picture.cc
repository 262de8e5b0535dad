// A sentence becomes a furnished room, the room a picture all around.     room_picture "a sentence" OUT.png [WIDTH]
#include <fastscene/rooms.h>

#include <iostream>

using namespace fastscene;

// Long work reports here; without a listener it is silent.
struct PrintNotes : EventSink {
    void tell(const Event& event) override {
        if (const auto* warning = std::get_if<WarningEvent>(&event)) std::cerr << "warning: " << warning->text << '\n';
    }
};

int main(int argc, char** argv) try {
    if (argc < 3) throw UsageError("usage: room_picture \"a sentence\" OUT.png [WIDTH]");
    const int width = argc > 3 ? std::stoi(argv[3]) : 512;
    PrintNotes notes;
    Run run;
    run.seed = 1;
    run.events = &notes;

    // What the sentence asks for. The report tells which words were not understood.
    PromptSpec prompt = understand_prompt(argv[1], /*strict=*/false);
    for (const PromptWord& word : prompt.words_with(PromptWord::Fate::not_understood))
        std::cerr << "not understood: " << word.words << '\n';

    // The room: triangles, materials and lights. The origin of its world is a free place at eye height; x points right,
    // y down, z forward, in metres.
    const Room room = make_room(prompt, run);
    for (const RoomObject& object : room.objects)
        if (object.requested) std::cout << object.name << '\n';

    // Light is gathered once and serves all pictures of the room.
    TracedRoom traced(room);
    TraceParams params;
    params.cell_m = 0.06f;     // coarse and quick; the default is 0.03
    params.cell_samples = 64;  // the default is 192
    traced.gather_light(params, run);
    const Rigid world_from_camera{};  // the identity: the camera stands at the origin
    const Shot shot = traced.panorama(world_from_camera, {width, width / 2}, final_parts(32), run);
    save_png(argv[2], srgb8_from_linear(shot.color));  // colors are linear until they are saved
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
