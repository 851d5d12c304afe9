// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QTemporaryDir>

#include <array>
#include <cstdint>

namespace test {

/// Stands in for spacenavd, the driver of 6-DoF devices: it listens at a local socket and sends
/// what the test says, by version 0 of the driver's protocol.
class SpaceDriver {
public:
    using Record = std::array<std::int32_t, 8>;

    SpaceDriver();
    ~SpaceDriver();
    SpaceDriver(const SpaceDriver&) = delete;
    SpaceDriver& operator=(const SpaceDriver&) = delete;

    [[nodiscard]] QString socketPath() const
    {
        return m_folder.filePath(QStringLiteral("spnav.sock"));
    }
    /// Waits for a program to connect. @return whether one did
    bool accept();
    void say(const Record& record);
    void sayBytes(const void* bytes, std::size_t count);
    void hangUp();

    /// Returns a record of a deflected cap: x to the right, y up, z away from the user, then the
    /// rotations about these axes. Full deflection is 350.
    [[nodiscard]] static Record motion(
        const std::array<std::int32_t, 6>& axes, int milliseconds = 10);
    [[nodiscard]] static Record button(int number, bool pressed);

private:
    QTemporaryDir m_folder;
    int m_listening = -1;
    int m_client = -1;
};

} // namespace test
