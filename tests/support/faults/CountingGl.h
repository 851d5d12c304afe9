// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace test {

/// Counts the GL objects (buffers, textures, framebuffers, vertex arrays, queries, shaders,
/// programs, fences) that this process creates and deletes while the object lives. One at a time;
/// GL is called by a single thread.
class CountingGl {
public:
    CountingGl();
    ~CountingGl();
    CountingGl(const CountingGl&) = delete;
    CountingGl& operator=(const CountingGl&) = delete;

    [[nodiscard]] int made() const;
    [[nodiscard]] int living() const; ///< those created meanwhile and not deleted
};

} // namespace test
