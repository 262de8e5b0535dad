// The training loop: it learns, interruptions leave no trace, a full disk costs no checkpoint.
#include "fastscene/nn/training.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/forced_exit.h"
#include "fastscene/base/parallel.h"
#include "fastscene/nn/layers.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/process_group.h"

namespace fastscene::nn {
namespace {

namespace fs = std::filesystem;

struct Folder {
    fs::path path;
    explicit Folder(const std::string& name) : path(fs::temp_directory_path() / (name + std::to_string(::getpid()))) {
        fs::remove_all(path);
    }
    ~Folder() { fs::remove_all(path); }
};

at::Tensor small_network(const Scope& s, const at::Tensor& x) {
    return linear(s / "out", at::relu(linear(s / "in", x, 16)), 1);
}

// Learns y = x0 x1 from examples.
struct Lesson {
    Learner learner;
    TrainingTask task;
    explicit Lesson(std::uint64_t seed = 3)
        : learner("net", start_he(seed), at::kFloat,
                  [](const Scope& s) {
                      small_network(s, at::zeros({1, 2}));
                  },
                  {{.learning_rate = 1e-2, .beta1 = 0.9}, 0.98, 10}) {
        task.learners = {&learner};
        task.draw = [](Random& rng) -> Batch {
            at::Tensor x = at::empty({32, 2});
            for (std::int64_t i = 0; i < x.numel(); ++i) x.data_ptr<float>()[i] = rng.uniform(-1, 1);
            return {x};
        };
        task.step = [this](const Batch& batch, std::int64_t, double learning_rate) -> Numbers {
            const at::Tensor loss = at::mse_loss(small_network(learner.scope(), batch[0]).squeeze(1), batch[0].prod(1));
            loss.backward();
            const double length = learner.update(learning_rate);
            return {{"loss", loss.item<double>()}, {"gradient", length}};
        };
        task.evaluate = [this]() -> Evaluation {
            Random rng(99, "held out");
            const Batch batch = task.draw(rng);
            return {
                {{"loss",
                  at::mse_loss(small_network(learner.ema(), batch[0]).squeeze(1), batch[0].prod(1)).item<double>()}},
                {}};
        };
        task.settings = {{"what", "a product"}};
    }
};

TrainingParams quick(int steps) {
    TrainingParams params;
    params.steps = steps;
    params.learning_rate = 1e-2;
    params.final_learning_rate = 1e-2;
    params.warmup = 5;
    params.ema_decay = 0.98;
    params.log_steps = 10;
    params.eval_steps = 50;
    params.precision = "f32";
    return params;
}

fastscene::Run seeded(std::uint64_t seed, std::stop_token stop = {}) { return {seed, nullptr, std::move(stop)}; }

std::vector<float> all_numbers(const Learner& learner) {
    std::vector<float> out;
    for (const auto& [name, tensor] : learner.state())
        for (const float v : weight_of(tensor).floats()) out.push_back(v);
    return out;
}

// A picture passes through GELU and is transposed to tokens: its gradient arrives in another memory layout.
TEST(Training, GeluHasItsGradientInAnyLayout) {
    const at::Tensor picture = at::randn({2, 8, 16, 32}), weight = at::randn({2, 16 * 32, 8});
    const auto gradient = [&](at::ScalarType type, const std::function<at::Tensor(const at::Tensor&)>& activation) {
        const at::Tensor x = picture.to(type).clone().set_requires_grad(true);
        (activation(x).flatten(2).transpose(1, 2).contiguous() * weight.to(type)).sum().backward();
        return x.grad().to(at::kDouble);
    };
    const at::Tensor exact = gradient(at::kDouble,
                                      [](const at::Tensor& x) { return x * 0.5 * (1 + at::erf(x * M_SQRT1_2)); });
    EXPECT_LT((gradient(at::kFloat, exact_gelu) - exact).abs().max().item<double>(), 1e-5);
}

TEST(Training, Learns) {
    const Folder folder("fastscene-training-learns");
    Lesson lesson;
    const double before = lesson.task.evaluate().held_out[0].second;
    const TrainingOutcome outcome = train(lesson.task, quick(400), folder.path, seeded(7));
    EXPECT_TRUE(outcome.finished);
    EXPECT_LT(outcome.held_out[0].second, 0.2 * before);
    EXPECT_TRUE(fs::exists(folder.path / "curve-loss.svg"));
    EXPECT_TRUE(read_file(folder.path / "curves.csv").starts_with("step,minutes,held-out loss"));
    EXPECT_EQ(lesson.learner.kept().tensors.size(), 4u);
}

TEST(Training, ABreakLeavesNoTrace) {
    set_threads(1);
    const Folder whole("fastscene-training-whole"), broken("fastscene-training-broken");
    Lesson at_once;
    train(at_once.task, quick(60), whole.path, seeded(7));
    {
        Lesson first;
        const TrainingOutcome outcome = train(first.task, quick(30), broken.path, seeded(7));
        EXPECT_EQ(outcome.steps, 30);
    }
    Lesson second(/*another beginning, which the checkpoint replaces*/ 4);
    EXPECT_EQ(train(second.task, quick(60), broken.path, seeded(7)).steps, 60);
    EXPECT_EQ(all_numbers(at_once.learner), all_numbers(second.learner));
    EXPECT_EQ(second.learner.steps(), 60);
    set_threads(0);
}

TEST(Training, StopsWithACheckpoint) {
    const Folder folder("fastscene-training-stop");
    std::stop_source stop;
    Lesson lesson;
    const auto step = lesson.task.step;
    lesson.task.step = [&](const Batch& batch, std::int64_t i, double learning_rate) {
        if (i == 12) stop.request_stop();
        return step(batch, i, learning_rate);
    };
    EXPECT_THROW(train(lesson.task, quick(1000), folder.path, seeded(7, stop.get_token())), Stopped);
    Lesson again;
    EXPECT_EQ(train(again.task, quick(20), folder.path, seeded(7)).steps, 20);
    EXPECT_EQ(again.learner.steps(), 20);
}

// Ended within its 13th step, after the gradients and before the update: the 12 before it are kept, and what follows is
// as if it had never ended.
TEST(Training, AForcedExitWithinAStepKeepsThoseBeforeIt) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    set_threads(1);
    const fs::path root = fs::temp_directory_path();
    // A death test runs this test again in a process of its own: the folder's name must be the same there.
    const fs::path folder = root / "fastscene-training-forced", whole = root / "fastscene-training-not-forced";
    const auto play = [&] {
        Lesson lesson;
        const auto step = lesson.task.step;
        lesson.task.step = [&](const Batch& batch, std::int64_t i, double learning_rate) {
            if (i == 12) {
                at::mse_loss(small_network(lesson.learner.scope(), batch[0]).squeeze(1), batch[0].prod(1)).backward();
                if (begin_forced_exit()) ::_exit(3);
            }
            return step(batch, i, learning_rate);
        };
        train(lesson.task, quick(1000), folder, seeded(7));
    };
    fs::remove_all(folder), fs::remove_all(whole);
    EXPECT_EXIT(play(), testing::ExitedWithCode(3), "");
    Lesson at_once, again;
    EXPECT_EQ(load_weights(folder / "checkpoint.safetensors").metadata.at("step"), "12");
    EXPECT_EQ(train(again.task, quick(20), folder, seeded(7)).steps, 20);
    train(at_once.task, quick(20), whole, seeded(7));
    EXPECT_EQ(all_numbers(at_once.learner), all_numbers(again.learner));
    fs::remove_all(folder), fs::remove_all(whole);
    set_threads(0);
}

// From the first gradient that is applied to the end of the step, the exit is held.
TEST(Training, AnUpdateIsNotCutInTwo) {
    const Folder folder("fastscene-training-held");
    Lesson lesson;
    const auto step = lesson.task.step;
    int held = 0;
    lesson.task.step = [&](const Batch& batch, std::int64_t i, double learning_rate) {
        const Numbers numbers = step(batch, i, learning_rate);
        held += begin_forced_exit() ? 0 : 1;
        return numbers;
    };
    train(lesson.task, quick(5), folder.path, seeded(7));
    EXPECT_EQ(held, 5);
}

// A first step that takes long is told of, with the time that all will take.
TEST(Training, TheFirstNewsComesBeforeTheFirstStep) {
    struct Notes : EventSink {
        std::mutex mutex;
        std::vector<std::string> texts;
        void tell(const Event& event) override {
            const std::lock_guard lock(mutex);
            if (const auto* note = std::get_if<NoteEvent>(&event)) texts.push_back(note->text);
        }
    } notes;
    const Folder folder("fastscene-training-news");
    Lesson lesson;
    const auto step = lesson.task.step;
    bool told_before_step = false;
    lesson.task.step = [&](const Batch& batch, std::int64_t i, double learning_rate) {
        if (i == 0) {
            small_network(lesson.learner.scope(), batch[0]);
            std::this_thread::sleep_for(std::chrono::milliseconds(8500));
            const std::lock_guard lock(notes.mutex);
            for (const std::string& text : notes.texts)
                told_before_step |= text.starts_with("training: first step, 33 % in 7 s; a step takes about 21 s");
        }
        return step(batch, i, learning_rate);
    };
    train(lesson.task, quick(3), folder.path, {7, &notes, {}});
    EXPECT_TRUE(told_before_step) << (notes.texts.empty() ? "nothing" : notes.texts.back());
}

// An unused TCP port.
int free_port() {
    const int s = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    EXPECT_EQ(::bind(s, reinterpret_cast<sockaddr*>(&at), sizeof at), 0);
    EXPECT_EQ(::getsockname(s, reinterpret_cast<sockaddr*>(&at), &size), 0);
    ::close(s);
    return ntohs(at.sin_port);
}

// Two processes with a batch each learn the same as one process with both batches; only rank 0 writes, and when it
// stops, all stop.
TEST(Training, AProcessGroupLearnsAsOneProcessWithAllExamples) {
    constexpr int kSteps = 20;
    const Folder one("fastscene-training-one"), first("fastscene-training-first"), second("fastscene-training-second");
    Lesson alone;
    const auto draw = alone.task.draw;
    const auto of_step = [&](std::int64_t step) {  // the random streams of both processes
        Random a(7, "training step", static_cast<std::uint64_t>(2 * step)),
            b(7, "training step", static_cast<std::uint64_t>(2 * step + 1));
        return Batch{at::cat({draw(a)[0], draw(b)[0]})};
    };
    const auto step = alone.task.step;
    alone.task.step = [&](const Batch&, std::int64_t i, double learning_rate) {
        return step(of_step(i), i, learning_rate);
    };
    train(alone.task, quick(kSteps), one.path, seeded(7));

    TrainingParams params = quick(kSteps);
    params.processes = 2;
    params.meet = fmt::format("localhost:{}", free_port());
    Lesson a, b(/*another beginning: the first's counts*/ 4);
    auto other = std::async(std::launch::async, [&, params]() mutable {
        params.process = 1;
        return train(b.task, params, second.path, seeded(7)).steps;
    });
    EXPECT_EQ(train(a.task, params, first.path, seeded(7)).steps, kSteps);
    EXPECT_EQ(other.get(), kSteps);
    EXPECT_EQ(all_numbers(a.learner), all_numbers(b.learner));
    const std::vector<float> together = all_numbers(a.learner), whole = all_numbers(alone.learner);
    ASSERT_EQ(together.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(together[i], whole[i], 2e-4) << i;
    EXPECT_TRUE(fs::exists(first.path / "checkpoint.safetensors"));
    EXPECT_FALSE(fs::exists(second.path));
}

TEST(Training, AProcessGroupThatCannotFormSaysSo) {
    TrainingParams params = quick(1);
    params.processes = 2;
    EXPECT_THROW(ProcessGroup::join(params, seeded(7)), UsageError);  // invalid address
    params.meet = "localhost:0";
    EXPECT_THROW(ProcessGroup::join(params, seeded(7)), UsageError);
    params.meet = fmt::format("localhost:{}", free_port());
    params.process = 2;
    EXPECT_THROW(ProcessGroup::join(params, seeded(7)), UsageError);
    params.process = 0;
    EXPECT_THROW(ProcessGroup::join(params, seeded(7), 1.5), Error);  // nobody joins
}

TEST(Training, AFolderKeepsItsSettings) {
    const Folder folder("fastscene-training-settings");
    Lesson lesson;
    train(lesson.task, quick(5), folder.path, seeded(7));
    TrainingParams other = quick(10);
    other.batch = 5;
    EXPECT_THROW(train(lesson.task, other, folder.path, seeded(7)), UsageError);
    EXPECT_THROW(train(lesson.task, quick(10), folder.path, seeded(8)), UsageError);
    lesson.task.settings["what"] = "a sum";
    EXPECT_THROW(train(lesson.task, quick(10), folder.path, seeded(7)), UsageError);
}

TEST(Training, AFullDiskLeavesTheLastCheckpoint) {
    const Folder folder("fastscene-training-full");
    Lesson lesson;
    train(lesson.task, quick(10), folder.path, seeded(7));
    const std::string before = read_file(folder.path / "checkpoint.safetensors");
    rlimit old{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{before.size() / 2, old.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(train(lesson.task, quick(20), folder.path, seeded(7)), Error);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(read_file(folder.path / "checkpoint.safetensors"), before);
    EXPECT_EQ(train(lesson.task, quick(20), folder.path, seeded(7)).steps, 20);
}

TEST(Training, AnInfiniteGradientIsLeftOut) {
    Lesson lesson;
    const std::vector<float> before = all_numbers(lesson.learner);
    (small_network(lesson.learner.scope(), at::ones({1, 2})).sum() * std::numeric_limits<float>::infinity()).backward();
    EXPECT_TRUE(std::isnan(lesson.learner.update(1e-2)));
    EXPECT_EQ(all_numbers(lesson.learner), before);
}

TEST(Training, TheRateWarmsUpAndFades) {
    TrainingParams params;
    params.steps = 1000;
    params.learning_rate = 1;
    params.final_learning_rate = 0.1;
    params.warmup = 10;
    EXPECT_DOUBLE_EQ(learning_rate_at(params, 0), 0.1);
    EXPECT_NEAR(learning_rate_at(params, 500), 0.55, 1e-12);
    EXPECT_NEAR(learning_rate_at(params, 1000), 0.1, 1e-12);
}

TEST(Training, AutocastComputesInBfloat16) {
    const at::Tensor x = at::ones({1, 4, 8, 8}), kernel = at::ones({4, 4, 3, 3});
    {
        const Autocast on(at::kCPU, true);
        EXPECT_EQ(at::conv2d(x, kernel).scalar_type(), at::kBFloat16);
    }
    EXPECT_EQ(at::conv2d(x, kernel).scalar_type(), at::kFloat);
}

}  // namespace
}  // namespace fastscene::nn
