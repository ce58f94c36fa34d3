#pragma once

// Templates of Eigen and nlohmann-json that many sources use and that take long to compile; Instances.cpp compiles them
// once. With optimisation this saves time only for functions that are not inline: every source compiles the others, to
// inline them.
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <nlohmann/json.hpp>

#include <string>

#ifndef NAOCAL_INSTANCE
#define NAOCAL_INSTANCE extern template
#endif

namespace Eigen {

// Decompositions
NAOCAL_INSTANCE LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
NAOCAL_INSTANCE LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
NAOCAL_INSTANCE SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, int);
NAOCAL_INSTANCE class ColPivHouseholderQR<MatrixXd>;
NAOCAL_INSTANCE class PartialPivLU<MatrixXd>;
NAOCAL_INSTANCE class JacobiSVD<MatrixXd>;

namespace internal {

// Kernels of products: rows x columns (gemm), rows x vector (gemv)
using Kernel = gebp_traits<double, double>;
using Into = blas_data_mapper<double, Index, ColMajor, 0, 1>;
using Columns = const_blas_data_mapper<double, Index, ColMajor>;
using Rows = const_blas_data_mapper<double, Index, RowMajor>;
NAOCAL_INSTANCE struct gebp_kernel<double, double, Index, Into, Kernel::mr, Kernel::nr, false, false>;
NAOCAL_INSTANCE struct gemm_pack_lhs<double, Index, Rows, Kernel::mr, Kernel::LhsProgress, Kernel::LhsPacket4Packing, RowMajor, false, false>;
NAOCAL_INSTANCE struct gemm_pack_lhs<double, Index, Columns, Kernel::mr, Kernel::LhsProgress, Kernel::LhsPacket4Packing, ColMajor, false, false>;
NAOCAL_INSTANCE struct gemm_pack_lhs<double, Index, Into, Kernel::mr, Kernel::LhsProgress, Kernel::LhsPacket4Packing, ColMajor, false, true>;
NAOCAL_INSTANCE struct gemm_pack_rhs<double, Index, Columns, Kernel::nr, ColMajor, false, false>;
NAOCAL_INSTANCE struct gemm_pack_rhs<double, Index, Rows, Kernel::nr, RowMajor, false, false>;
NAOCAL_INSTANCE struct gemm_pack_rhs<double, Index, Rows, Kernel::nr, RowMajor, false, true>;
NAOCAL_INSTANCE struct gemm_pack_rhs<double, Index, Into, Kernel::nr, ColMajor, false, true>;
NAOCAL_INSTANCE struct general_matrix_vector_product<Index, double, Rows, RowMajor, false, double, Columns, false>;
NAOCAL_INSTANCE struct general_matrix_vector_product<Index, double, Columns, ColMajor, false, double, Rows, false>;
NAOCAL_INSTANCE struct general_matrix_vector_product<Index, double, Columns, ColMajor, false, double, Columns, false>;
NAOCAL_INSTANCE struct general_matrix_vector_product<Index, double, Rows, RowMajor, false, double, Rows, false, 1>;

// Triangular matrices
NAOCAL_INSTANCE struct triangular_solve_matrix<double, Index, OnTheRight, Upper, false, RowMajor, ColMajor, 1>;
NAOCAL_INSTANCE struct triangular_solve_matrix<double, Index, OnTheLeft, Lower, false, ColMajor, ColMajor, 1>;
NAOCAL_INSTANCE struct triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false, ColMajor, ColMajor, 1>;
NAOCAL_INSTANCE struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, RowMajor, ColMajor, 1>;
NAOCAL_INSTANCE struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, ColMajor, ColMajor, 1>;
NAOCAL_INSTANCE struct triangular_solve_matrix<double, Index, OnTheLeft, UnitUpper, false, RowMajor, ColMajor, 1>;
NAOCAL_INSTANCE struct product_triangular_matrix_matrix<double, Index, UnitLower, true, ColMajor, false, ColMajor, false, ColMajor, 1>;
NAOCAL_INSTANCE struct product_triangular_matrix_matrix<double, Index, Lower, true, ColMajor, false, ColMajor, false, ColMajor, 1>;
NAOCAL_INSTANCE struct product_triangular_matrix_matrix<double, Index, Upper, true, RowMajor, false, ColMajor, false, ColMajor, 1>;
NAOCAL_INSTANCE struct product_triangular_matrix_matrix<double, Index, UnitUpper, true, RowMajor, false, ColMajor, false, ColMajor, 1>;
NAOCAL_INSTANCE struct triangular_solve_vector<double, double, Index, OnTheLeft, UnitLower, false, ColMajor>;
NAOCAL_INSTANCE struct triangular_solve_vector<double, double, Index, OnTheLeft, Lower, false, ColMajor>;
NAOCAL_INSTANCE struct triangular_solve_vector<double, double, Index, OnTheLeft, Upper, false, ColMajor>;
NAOCAL_INSTANCE struct triangular_matrix_vector_product<Index, UnitUpper, double, false, double, false, RowMajor>;

} // namespace internal
} // namespace Eigen

namespace nlohmann {
NAOCAL_INSTANCE class basic_json<>;

namespace detail {
using FromString = iterator_input_adapter<std::string::const_iterator>;
NAOCAL_INSTANCE class lexer<json, FromString>;
NAOCAL_INSTANCE class parser<json, FromString>;
NAOCAL_INSTANCE class json_sax_dom_parser<json>;
NAOCAL_INSTANCE class json_sax_dom_callback_parser<json>;
NAOCAL_INSTANCE class serializer<json>;
} // namespace detail
} // namespace nlohmann
