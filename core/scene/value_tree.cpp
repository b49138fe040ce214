#include "core/scene/value_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <utility>

namespace stylet::core {
namespace {

/// Thrown through the parser where going on makes no sense.
struct Refusal {
    YAML::Mark mark;
    std::string sentence;
};

Place place_of(const YAML::Mark& mark, const Place& start) {
    if (start.line == 0) return start;
    // An error without a mark, or at the very end of a text, is the text's.
    if (mark.is_null() || mark.line < 0) return start;
    return {start.file, start.line + mark.line, mark.column + 1};
}

/// Builds the tree from the parser's events; by its own stack, so that no depth of nesting can exhaust the program's.
class TreeBuilder : public YAML::EventHandler {
public:
    TreeBuilder(Place start, Complaints& complaints) : start_(std::move(start)), complaints_(complaints) {}

    ValueTree take() {
        if (refusal_) throw *refusal_;
        return std::move(root_);
    }

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
        if (wants_key()) throw Refusal{mark, "found an empty key, wanted a word before the ':'"};
        // The parser's mark of a missing value is the next thing in the text; the key is where a reader looks.
        const Place place = !open_.empty() && open_.back().key ? open_.back().key_place : place_of(mark, start_);
        add({ValueTree::Shape::nothing, place});
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        throw Refusal{mark, "found an alias ('*name'), wanted the value itself: a scene writes every value out"};
    }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string& value) override {
        if (wants_key()) {
            open_.back().key = value;
            open_.back().key_place = place_of(mark, start_);
        } else {
            add({ValueTree::Shape::scalar, place_of(mark, start_), value});
        }
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
        begin(mark, ValueTree::Shape::list);
    }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
        begin(mark, ValueTree::Shape::map);
    }
    void OnSequenceEnd() override { end(); }
    void OnMapEnd() override { end(); }

private:
    struct Open {
        ValueTree node;
        std::string path;
        bool as_key;
        std::optional<std::string> key{};    // read, its value still to come
        Place key_place{};
        std::map<std::string, Place> seen{};
    };

    [[nodiscard]] bool wants_key() const {
        return !open_.empty() && open_.back().node.shape == ValueTree::Shape::map && !open_.back().key;
    }

    [[nodiscard]] std::string path_of_next() const {
        if (open_.empty()) return "";
        const Open& parent = open_.back();
        return parent.key ? join(parent.path, *parent.key) : join(parent.path, parent.node.items.size());
    }

    void begin(const YAML::Mark& mark, ValueTree::Shape shape) {
        constexpr std::size_t deepest = 64;    // a scene needs six
        if (open_.size() >= deepest) throw Refusal{mark, fmt::format("found values nested deeper than {}", deepest)};
        const bool as_key = wants_key();
        // Not thrown: a missing bracket further on looks like this, too, and is then what is wrong.
        if (as_key && !refusal_) refusal_ = Refusal{mark, "found a list or a map as a key, wanted a word"};
        open_.push_back({.node = {shape, place_of(mark, start_)}, .path = path_of_next(), .as_key = as_key});
    }

    void end() {
        Open done = std::move(open_.back());
        open_.pop_back();
        if (done.as_key) {
            open_.back().key = "";
        } else {
            add(std::move(done.node));
        }
    }

    void add(ValueTree node) {
        if (open_.empty()) {
            root_ = std::move(node);
            return;
        }
        Open& parent = open_.back();
        if (!parent.key) {
            parent.node.items.push_back(std::move(node));
            return;
        }
        const std::string key = *std::exchange(parent.key, std::nullopt);
        const auto [first, is_new] = parent.seen.try_emplace(key, parent.key_place);
        if (is_new) {
            parent.node.entries.push_back({key, parent.key_place, std::move(node)});
        } else {
            const std::string where = first->second.line > 0 ? fmt::format(" (first on line {})", first->second.line) : "";
            complaints_.add(parent.key_place, join(parent.path, key), "found the key a second time" + where + ", wanted it once");
        }
    }

    Place start_;
    Complaints& complaints_;
    ValueTree root_;
    std::vector<Open> open_;
    std::optional<Refusal> refusal_;    // to be made once the text has proved to be YAML
};

}    // namespace

std::optional<ValueTree> parse_yaml(const std::string& text, const Place& start, Complaints& complaints) {
    try {
        std::istringstream stream(text);
        YAML::Parser parser(stream);
        TreeBuilder builder(start, complaints);
        if (!parser.HandleNextDocument(builder)) return ValueTree(ValueTree::Shape::nothing, start);
        TreeBuilder surplus(start, complaints);
        if (parser.HandleNextDocument(surplus)) {
            complaints.add(start, "", "found a second YAML document (after '---' or '...'), wanted one");
            return std::nullopt;
        }
        return builder.take();
    } catch (const Refusal& refusal) {
        complaints.add(place_of(refusal.mark, start), "", refusal.sentence);
    } catch (const YAML::Exception& error) {
        complaints.add(
            place_of(error.mark, start), "",
            fmt::format("found text that is not YAML ({}), wanted evenly indented 'key: value', every bracket and quote closed",
                        error.msg));
    } catch (const std::exception& error) {
        complaints.add(start, "", fmt::format("found text on which the YAML parser gave up: {}", error.what()));
    }
    return std::nullopt;
}

ValueTree::ValueTree(Shape is, Place stands, std::string says) : shape(is), place(std::move(stands)), text(std::move(says)) {}

const ValueTree* ValueTree::find(const std::string& key) const {
    for (const Entry& entry : entries) {
        if (entry.key == key) return &entry.value;
    }
    return nullptr;
}

ValueTree* ValueTree::find(const std::string& key) {
    return const_cast<ValueTree*>(std::as_const(*this).find(key));
}

std::vector<std::string> ValueTree::keys() const {
    std::vector<std::string> keys;
    for (const Entry& entry : entries) keys.push_back(entry.key);
    return keys;
}

std::string ValueTree::description() const {
    switch (shape) {
        case Shape::scalar:
            return quote(text);
        case Shape::list:
            return items.empty() ? "an empty list" : "a list";
        case Shape::map:
            return "a map";
        case Shape::nothing:
            break;
    }
    return "nothing";
}

std::string join(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
}

std::string join(const std::string& path, std::size_t index) {
    return fmt::format("{}[{}]", path, index);
}

}    // namespace stylet::core
