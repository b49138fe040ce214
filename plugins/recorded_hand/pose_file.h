#pragma once

#include <stylet/hand_motion.h>

#include <string>
#include <vector>

namespace stylet::recorded_hand {

/// Reads base poses from a CSV file: any lines that begin with `#`, then the header `time [s],x [m],y [m],z [m],qw,qx,qy,qz`,
/// then rows whose times are not negative and rise strictly and whose quaternions are unit to 1e-3 (they are normalised). Throws
/// Error at `file` with the line at fault.
[[nodiscard]] std::vector<PoseKey> read_pose_file(const std::string& path);

}    // namespace stylet::recorded_hand
