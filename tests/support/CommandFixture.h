// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/Edits.h"
#include "core/volume/Volume.h"
#include "tests/support/BurinProgram.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>

#include <memory>
#include <vector>

namespace test {

/// Writes a study whose codes are its values + 1024, as NIfTI. @return whether it could
[[nodiscard]] bool writeStudy(const QString& path, const core::LoadedVolume& study);

/// A word of JSON or of the command line.
[[nodiscard]] QString key(const char* name);
/// An entry of a recipe.
[[nodiscard]] QJsonObject goTo(int seq);
/// As a recipe's list of edits.
[[nodiscard]] QJsonArray toJson(const std::vector<core::Edit>& edits);

/// A study and a folder, new for every test function, for what the program is told to do there.
class CommandFixture {
protected:
    /// The small study, for all test functions. @return whether it could be written
    [[nodiscard]] bool prepareStudy();
    void makeFolder() { m_folder = std::make_unique<QTemporaryDir>(); }

    [[nodiscard]] const QString& study() const { return m_study; }
    /// One that outlives the test function; empty: it could not be written.
    [[nodiscard]] QString otherStudy(const char* name, const core::LoadedVolume& study) const;
    [[nodiscard]] QString path(const char* name) const;
    [[nodiscard]] QString recipe(const char* name, const QJsonObject& content) const;
    [[nodiscard]] Outcome run(
        const QString& recipeFile, const char* session, const QStringList& more = {}) const;
    /// What a session did, as a recipe under that name. @return its path
    [[nodiscard]] QString recipeOf(const char* session, const char* name) const;
    /// `burin history --json`
    [[nodiscard]] QJsonObject history(const char* session) const;
    /// The state hash of a session's last row, hex.
    [[nodiscard]] QString lastHash(const char* session) const;

private:
    QTemporaryDir m_studies;
    QString m_study;
    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace test
