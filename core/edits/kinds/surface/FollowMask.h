// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Have what is yellow follow the boundary of what the segment holds now. Red and green stay.
struct FollowMask { };

} // namespace core
