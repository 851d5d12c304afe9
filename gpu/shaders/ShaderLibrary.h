// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <stdexcept>
#include <utility>
#include <vector>

namespace gpu {

/// A shader cannot be read, resolved, compiled or linked: a fault of ours or of a driver. Thrown
/// and caught inside gpu; the message names file and line.
class ShaderError : public std::runtime_error {
public:
    explicit ShaderError(const QString& message)
        : std::runtime_error(message.toStdString())
    {
    }
};

/// `#define name value` lines put in before the file.
using ShaderDefines = std::vector<std::pair<const char*, int>>;

/// One translation unit, ready for the driver.
struct ShaderSource {
    QByteArray text;
    QStringList files; ///< source string number n of #line → path below the root

    /// A driver's log with "0:12", "0(12)" and their like turned into
    /// "render/raycast/raycast.frag:12".
    [[nodiscard]] QString withFileNames(const QString& driverLog) const;
};

/// GLSL in files. Resolves `#include "path below the root"` (each file at most once per unit; a
/// cycle is an error that shows the chain) and begins the unit with #version and the defines. Files
/// carry no #version of their own. Needs no GL.
class ShaderLibrary {
public:
    /// The files built into the program, named by their path in gpu/
    /// ("render/raycast/raycast.frag").
    [[nodiscard]] static ShaderLibrary builtIn();
    /// Files below a folder of the file system or of the resources.
    explicit ShaderLibrary(QString root);

    /// Throws ShaderError.
    [[nodiscard]] ShaderSource load(const QString& path, const ShaderDefines& defines = {}) const;

private:
    void append(
        const QString& path, QStringList& chain, QStringList& once, ShaderSource& source) const;

    QString m_root;
};

} // namespace gpu
