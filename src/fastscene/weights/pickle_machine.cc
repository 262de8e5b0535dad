#include "fastscene/weights/pickle_machine.h"

#include <charconv>
#include <cstring>
#include <unordered_map>

#include "fastscene/base/error.h"

namespace fastscene::pickle {
namespace {

// Limit; a checkpoint with thousands of tensors has a few hundred thousand values.
constexpr std::size_t kMostValues = std::size_t{1} << 22;
// Maximum dimensions of a tensor.
constexpr std::size_t kMostSides = 16;
// Maximum length of a copied name (of a class or a storage).
constexpr std::size_t kLongestName = 256;

std::int64_t whole(const Ref& value) {
    if (const auto* number = value->as<std::int64_t>()) return *number;
    return -1;
}

std::vector<std::int64_t> whole_list(const Sequence& list) {
    std::vector<std::int64_t> out;
    for (const Ref& item : list.items) out.push_back(whole(item));
    return out;
}

bool is_dictionary(std::string_view name) {
    return name == "collections.OrderedDict" || name == "builtins.dict" || name == "__builtin__.dict";
}
bool is_parameter(std::string_view name) {
    return name == "torch._utils._rebuild_parameter" || name == "torch._utils._rebuild_parameter_with_state";
}
bool is_module(std::string_view name) { return name.starts_with("__torch__."); }
bool is_tensor(std::string_view name) {
    return name == "torch._utils._rebuild_tensor_v2" || name == "torch._utils._rebuild_tensor";
}

class Machine {
  public:
    Machine(std::string_view bytes, std::size_t begin, std::size_t base, const std::filesystem::path& path)
        : bytes_(bytes), at_(begin), base_(base), path_(path) {}

    Pickle run() {
        while (true) {
            start_ = at_;
            const unsigned char op = byte();
            if (op == '.') break;
            step(op);
        }
        out_.root = pop();
        out_.end = at_;
        return std::move(out_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error("{}: byte {}: {}", path_.string(), base_ + start_, what);
    }

    // ---- the bytes ----
    std::string_view take(std::uint64_t count) {
        if (count > bytes_.size() - at_)
            fail(fmt::format("expected {} more bytes, found {} (cut off?)", count, bytes_.size() - at_));
        const std::string_view out = bytes_.substr(at_, count);
        at_ += count;
        return out;
    }
    unsigned char byte() { return static_cast<unsigned char>(take(1)[0]); }
    template <class T>
    T number() {
        T out;
        std::memcpy(&out, take(sizeof(T)).data(), sizeof(T));
        return out;
    }
    std::string_view line() {
        const std::size_t end = bytes_.find('\n', at_);
        if (end == std::string_view::npos) fail("expected a line's end, found none");
        const std::string_view out = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return out;
    }

    // ---- values ----
    template <class T>
    Ref make(T value) {
        if (out_.values.size() >= kMostValues)
            fail(fmt::format("expected a checkpoint, found more than {} values", kMostValues));
        return &out_.values.emplace_back(Value{std::move(value)});
    }
    Ref global(std::string_view module, std::string_view name) {
        if (module.size() + name.size() > kLongestName) return make(Opaque{});
        return make(Global{std::string(module) + "." + std::string(name)});
    }
    // Budget for copied items: a short pickle could copy the same long list again and again.
    void spend(std::size_t items) {
        if ((copied_ += items) > bytes_.size() + kMostSides)
            fail("expected a checkpoint, found one list copied over and over");
    }

    // ---- the stack ----
    void push(Ref value) { stack_.push_back(std::move(value)); }
    Ref pop() {
        if (stack_.size() <= floor()) fail("expected a value on the stack, found none");
        Ref out = std::move(stack_.back());
        stack_.pop_back();
        return out;
    }
    Value& top() {
        if (stack_.size() <= floor()) fail("expected a value on the stack, found none");
        return *stack_.back();
    }
    std::size_t floor() const { return marks_.empty() ? 0 : marks_.back(); }
    std::vector<Ref> pop_to_mark() {
        if (marks_.empty()) fail("expected a mark, found none");
        std::vector<Ref> out(stack_.begin() + static_cast<std::ptrdiff_t>(marks_.back()), stack_.end());
        stack_.resize(marks_.back());
        marks_.pop_back();
        return out;
    }
    std::vector<Ref> pop_many(std::size_t count) {
        std::vector<Ref> out(count);
        for (std::size_t i = count; i-- > 0;) out[i] = pop();
        return out;
    }

    // ---- containers ----
    void append(const std::vector<Ref>& items) {
        // Appending to a value that is not a list (a set, an opaque value) has no effect.
        if (auto* list = std::get_if<Sequence>(&top().held))
            list->items.insert(list->items.end(), items.begin(), items.end());
    }
    void set_items(const std::vector<Ref>& items) {
        if (items.size() % 2) fail("expected keys and values, found an odd count");
        if (auto* dictionary = std::get_if<Dictionary>(&top().held))
            for (std::size_t i = 0; i < items.size(); i += 2) dictionary->items.emplace_back(items[i], items[i + 1]);
    }

    // ---- the memo ----
    void remember(std::uint64_t index) {
        (void)top();
        memo_[index] = stack_.back();
    }
    void recall(std::uint64_t index) {
        const auto found = memo_.find(index);
        if (found == memo_.end()) fail(fmt::format("expected value {} to be remembered, found none", index));
        push(found->second);
    }
    std::uint64_t line_index() {
        const std::string_view text = line();
        std::uint64_t out = 0;
        if (std::from_chars(text.data(), text.data() + text.size(), out).ec != std::errc()) fail("expected a number");
        return out;
    }

    // ---- calls: never executed; the few that make dictionaries and tensors are recognized ----
    // torch._utils._rebuild_tensor_v2(storage, offset, shape, stride, …)
    Ref tensor(const std::vector<Ref>& args) {
        if (args.size() < 4) return make(Opaque{});
        const auto* storage = args[0]->as<Storage>();
        const auto *shape = args[2]->as<Sequence>(), *stride = args[3]->as<Sequence>();
        if (!storage || !shape || !stride || shape->items.size() > kMostSides || stride->items.size() > kMostSides)
            return make(Opaque{});
        return make(Tensor{*storage, whole(args[1]), whole_list(*shape), whole_list(*stride)});
    }
    Ref dictionary(const std::vector<Ref>& args) {
        Dictionary out;
        if (const auto* pairs = args.empty() ? nullptr : args[0]->as<Sequence>()) {
            spend(pairs->items.size());
            for (const Ref& pair : pairs->items)
                if (const auto* two = pair->as<Sequence>(); two && two->items.size() == 2)
                    out.items.emplace_back(two->items[0], two->items[1]);
        }
        return make(std::move(out));
    }
    Ref called(std::string_view name, const std::vector<Ref>& args) {
        if (is_dictionary(name)) return dictionary(args);
        if (is_tensor(name)) return tensor(args);
        if (is_module(name)) return make(Module{});
        if (is_parameter(name) && !args.empty() && args[0]->as<Tensor>()) return args[0];
        return make(Opaque{});
    }
    void reduce() {
        const Ref arguments = pop(), function = pop();
        const auto* name = function->as<Global>();
        const auto* list = arguments->as<Sequence>();
        push(name && list ? called(name->name, list->items) : make(Opaque{}));
    }
    // An object's state: stored for a TorchScript module, otherwise attached to an opaque value. OrderedDict carries
    // its hooks this way.
    void build() {
        const Ref state = pop();
        if (auto* module = std::get_if<Module>(&top().held)) module->state = state;
    }
    // ('storage', torch.FloatStorage, '0', 'cpu', count[, view])
    void persistent(const Ref& id) {
        const auto* list = id->as<Sequence>();
        if (!list || list->items.size() < 5 || !list->items[2]->as<Text>() ||
            list->items[2]->as<Text>()->bytes.size() > kLongestName)
            return push(make(Opaque{}));
        Storage storage;
        if (const auto* type = list->items[1]->as<Global>())
            storage.dtype = type->name.substr(type->name.rfind('.') + 1);
        storage.key = std::string(list->items[2]->as<Text>()->bytes);
        storage.count = static_cast<std::uint64_t>(whole(list->items[4]));
        if (list->items.size() > 5)
            if (const auto* view = list->items[5]->as<Sequence>(); view && view->items.size() == 3) {
                storage.offset = static_cast<std::uint64_t>(whole(view->items[1]));
                if (whole(view->items[1]) < 0) fail("expected a storage's offset, found a negative number");
            }
        push(make(std::move(storage)));
    }

    // ---- numbers ----
    void push_long(std::string_view little_endian) {
        std::int64_t out = 0;
        if (little_endian.size() > 8) return push(make(Opaque{}));
        for (std::size_t i = 0; i < little_endian.size(); ++i)
            out |= static_cast<std::int64_t>(static_cast<unsigned char>(little_endian[i])) << (8 * i);
        if (!little_endian.empty() && little_endian.size() < 8 && (little_endian.back() & 0x80))
            out -= std::int64_t{1} << (8 * little_endian.size());
        push(make(out));
    }
    void push_line_number(bool is_whole) {
        std::string_view text = line();
        if (is_whole && (text == "00" || text == "01")) return push(make(text == "01"));
        if (text.ends_with('L')) text.remove_suffix(1);
        std::int64_t number = 0;
        double real = 0;
        const auto code = is_whole ? std::from_chars(text.data(), text.data() + text.size(), number).ec
                                   : std::from_chars(text.data(), text.data() + text.size(), real).ec;
        if (code != std::errc()) return push(make(Opaque{}));
        is_whole ? push(make(number)) : push(make(real));
    }

    void step(unsigned char op);

    std::string_view bytes_;
    std::size_t at_ = 0, start_ = 0, base_ = 0, copied_ = 0;
    Pickle out_;
    const std::filesystem::path& path_;
    std::vector<Ref> stack_;
    std::vector<std::size_t> marks_;
    std::unordered_map<std::uint64_t, Ref> memo_;
};

void Machine::step(unsigned char op) {
    switch (op) {
        case 0x80: (void)byte(); break;                     // PROTO
        case 0x95: (void)number<std::uint64_t>(); break;    // FRAME
        case '(': marks_.push_back(stack_.size()); break;   // MARK
        case '0': (void)pop(); break;                       // POP
        case '1': (void)pop_to_mark(); break;               // POP_MARK
        case '2': (void)top(), push(stack_.back()); break;  // DUP
        case 'N': push(make(None{})); break;
        case 0x88: push(make(true)); break;
        case 0x89: push(make(false)); break;
        case 'I':
        case 'L': push_line_number(true); break;   // INT, LONG
        case 'F': push_line_number(false); break;  // FLOAT
        case 'J': push(make(std::int64_t{number<std::int32_t>()})); break;
        case 'K': push(make(std::int64_t{byte()})); break;
        case 'M': push(make(std::int64_t{number<std::uint16_t>()})); break;
        case 0x8a: push_long(take(byte())); break;  // LONG1
        case 0x8b: push_long(take(number<std::uint32_t>())); break;
        case 'G': {  // BINFLOAT, big endian
            const std::uint64_t bits = __builtin_bswap64(number<std::uint64_t>());
            double value;
            std::memcpy(&value, &bits, 8);
            push(make(value));
            break;
        }
        case 'S':
        case 'V': {  // STRING 'text', UNICODE text
            std::string_view text = line();
            if (op == 'S' && text.size() >= 2) text = text.substr(1, text.size() - 2);
            push(make(Text{text}));
            break;
        }
        case 'U':
        case 'C':
        case 0x8c: push(make(Text{take(byte())})); break;
        case 'T':
        case 'X':
        case 'B': push(make(Text{take(number<std::uint32_t>())})); break;
        case 0x8d:
        case 0x8e:
        case 0x96: push(make(Text{take(number<std::uint64_t>())})); break;
        case ']':
        case 0x8f:
        case ')': push(make(Sequence{})); break;  // EMPTY_LIST, EMPTY_SET, EMPTY_TUPLE
        case 'l':
        case 't':
        case 0x91: push(make(Sequence{pop_to_mark()})); break;  // LIST, TUPLE, FROZENSET
        case 0x85: push(make(Sequence{pop_many(1)})); break;
        case 0x86: push(make(Sequence{pop_many(2)})); break;
        case 0x87: push(make(Sequence{pop_many(3)})); break;
        case 'a': append(pop_many(1)); break;  // APPEND
        case 'e':
        case 0x90: append(pop_to_mark()); break;  // APPENDS, ADDITEMS
        case '}': push(make(Dictionary{})); break;
        case 'd': {  // DICT
            const std::vector<Ref> items = pop_to_mark();
            push(make(Dictionary{}));
            set_items(items);
            break;
        }
        case 's': set_items(pop_many(2)); break;    // SETITEM
        case 'u': set_items(pop_to_mark()); break;  // SETITEMS
        case 'p': remember(line_index()); break;
        case 'q': remember(byte()); break;
        case 'r': remember(number<std::uint32_t>()); break;
        case 0x94: remember(memo_.size()); break;  // MEMOIZE
        case 'g': recall(line_index()); break;
        case 'h': recall(byte()); break;
        case 'j': recall(number<std::uint32_t>()); break;
        case 'c': {  // GLOBAL
            const std::string_view module = line();
            push(global(module, line()));
            break;
        }
        case 0x93: {  // STACK_GLOBAL
            const Ref name = pop(), module = pop();
            const bool texts = name->as<Text>() && module->as<Text>();
            push(texts ? global(module->as<Text>()->bytes, name->as<Text>()->bytes) : make(Opaque{}));
            break;
        }
        case 'R': reduce(); break;
        case 0x81: reduce(); break;               // NEWOBJ
        case 0x92: (void)pop(), reduce(); break;  // NEWOBJ_EX
        case 'o': (void)pop_to_mark(), push(make(Opaque{})); break;
        case 'i': (void)line(), (void)line(), (void)pop_to_mark(), push(make(Opaque{})); break;
        case 'b': build(); break;
        case 'Q': persistent(pop()); break;  // BINPERSID
        case 'P': (void)line(), push(make(Opaque{})); break;
        case 0x82: (void)byte(), push(make(Opaque{})); break;  // EXT1 …
        case 0x83: (void)number<std::uint16_t>(), push(make(Opaque{})); break;
        case 0x84: (void)number<std::uint32_t>(), push(make(Opaque{})); break;
        default: fail(fmt::format("expected a pickle's instruction, found {:#04x}", op));
    }
}

}  // namespace

Pickle read_pickle(std::string_view bytes, std::size_t begin, std::size_t base, const std::filesystem::path& path) {
    return Machine(bytes, begin, base, path).run();
}

}  // namespace fastscene::pickle
