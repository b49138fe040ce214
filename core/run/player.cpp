#include "core/run/player.h"

#include <chrono>

namespace stylet::core {

Player::Player(const Scene& scene, const Cast& cast, std::size_t most_ticks,
               const std::optional<std::filesystem::path>& recording)
    : simulation_(scene, cast), reporter_(scene, cast, most_ticks) {
    if (recording) {
        recorder_.emplace(*recording, Recorder::Heading{scene.title, scene.file.filename().string(), scene.hash},
                          columns_of(scene.record));
    }
}

void Player::tick(double held) {
    const auto start = std::chrono::steady_clock::now();
    simulation_.tick(held);
    duration_ = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    reported_ = false;
}

bool Player::note() {
    if (!reported_) reporter_.take(simulation_, duration_);
    reported_ = true;
    return !recorder_ || recorder_->push(simulation_.sample(), simulation_.events());
}

RunReport Player::finish() {
    if (recorder_) recorder_->finish();
    return reporter_.finish(simulation_);
}

}    // namespace stylet::core
