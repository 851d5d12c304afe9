// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Arguments.h"
#include "core/base/Result.h"
#include "core/sources/PacsSource.h"

#include <QString>

#include <vector>

namespace app {

/// The options of every verb that talks to a PACS source.
[[nodiscard]] std::vector<Option> sourceOptions();

/// What is wrong with them, in words of the command line: "--timeout: …".
/// @param error of sourceOf()
[[nodiscard]] QString sourceProblem(const core::Error& error);

/// The source that is named by the first word (an address, or the name of a source in the settings)
/// and the options of sourceOptions(). Logins are read from files and the environment, because
/// everybody can read a command line. Errors: InvalidField, those of core::WebLogin.
[[nodiscard]] core::Result<core::PacsSource> sourceOf(const Arguments& arguments);

} // namespace app
