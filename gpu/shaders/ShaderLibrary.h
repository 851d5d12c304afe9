// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <stdexcept>
#include <utility>
#include <vector>

namespace gpu {

/// A shader cannot be read, resolved, compiled or linked, because of a fault of ours or of the
/// driver. Thrown and caught inside gpu; the message names file and line.
class ShaderError : public std::runtime_error {
public:
    explicit ShaderError(const QString& message)
        : std::runtime_error(message.toStdString())
    {
    }
};

/// Lines `#define name value` that are put in front of the file.
using ShaderDefines = std::vector<std::pair<const char*, int>>;

/// The complete source of one shader, ready for the driver.
struct ShaderSource {
    QByteArray text;
    /// The file for each source string number of #line, as a path below the root.
    QStringList files;

    /// A driver's log in which "0:12", "0(12)" and the like are replaced by
    /// "render/raycast/raycast.frag:12".
    [[nodiscard]] QString withFileNames(const QString& driverLog) const;
};

/// Loads GLSL files. It resolves `#include "path below the root"` (each file at most once per unit;
/// a cycle is an error that shows the chain) and puts #version and the defines in front. Files
/// contain no #version of their own. Needs no GL.
class ShaderLibrary {
public:
    /// The files that are built into the program, named by their path in gpu/
    /// ("render/raycast/raycast.frag").
    [[nodiscard]] static ShaderLibrary builtIn();
    /// The files below a folder of the file system or of the Qt resources.
    explicit ShaderLibrary(QString root);

    /// Throws ShaderError.
    [[nodiscard]] ShaderSource load(const QString& path, const ShaderDefines& defines = {}) const;

private:
    void append(
        const QString& path, QStringList& chain, QStringList& once, ShaderSource& source) const;

    QString m_root;
};

} // namespace gpu
