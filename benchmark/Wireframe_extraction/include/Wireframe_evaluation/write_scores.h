// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef WIREFRAME_EVALUATION_WRITE_SCORES_H
#define WIREFRAME_EVALUATION_WRITE_SCORES_H

#include <Wireframe_evaluation/score_columns.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

namespace Wireframe_evaluation {

namespace internal {

inline std::string rounded(double x, int digits = 5)
{
  if (std::isnan(x))
    return "-";
  std::ostringstream out;
  out << std::setprecision(digits) << x;
  return out.str();
}

} // namespace internal

/// writes scores as a table to be read: lengths in the unit of the cloud, and in sampling distances.
inline void write_scores_as_text(std::ostream& out, const Wireframe_scores& scores)
{
  if (!scores.failure.empty())
    out << "no usable result: " << scores.failure << "\n\n";
  out << std::left << std::setw(30) << "sampling_distance" << std::setw(13)
      << internal::rounded(scores.sampling_distance) << "r\n"
      << std::setw(30) << "diagonal" << std::setw(13) << internal::rounded(scores.diagonal) << "of the box around the "
      << "true curves\n";
  for (const Score_column& column : score_columns())
  {
    const double x = column.get(scores);
    const bool is_length = column.unit == Score_unit::LENGTH && !std::isnan(x);
    const std::string in_r = is_length ? " (" + internal::rounded(x / scores.sampling_distance, 3) + " r)" : "";
    out << std::left << std::setw(30) << column.name << std::setw(12) << internal::rounded(x) << ' '
        << column.description << in_r << '\n';
  }
}

/// writes scores as one JSON object: lengths in the unit of the cloud, `null` where a score does not apply.
inline void write_scores_as_json(std::ostream& out, const Wireframe_scores& scores)
{
  nlohmann::ordered_json document;
  document["failure"] = scores.failure.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(scores.failure);
  document["sampling_distance"] = scores.sampling_distance;
  document["diagonal"] = scores.diagonal;
  for (const Score_column& column : score_columns())
  {
    const double x = column.get(scores);
    if (!std::isfinite(x))
      document[column.name] = nullptr;
    else if (column.unit == Score_unit::COUNT)
      document[column.name] = static_cast<long long>(x);
    else
      document[column.name] = x;
  }
  out << document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_WRITE_SCORES_H
