! SPDX-FileCopyrightText: 2026 The Meniscus authors
! SPDX-License-Identifier: Apache-2.0
! Areas of spheres from Fortran 2008, through the C interface (include/meniscus/meniscus.h).
module meniscus
  use, intrinsic :: iso_c_binding
  implicit none

  type, bind(c) :: totals_type
    real(c_double) :: sas_area, sas_volume, ses_area, ses_volume, contact_area, toroidal_area, reentrant_area
  end type

  interface
    integer(c_int) function meniscus_from_spheres(n, centres, radii, structure) bind(c)
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: centres(3, *), radii(*)
      type(c_ptr) :: structure
    end function
    integer(c_int) function meniscus_exact_new(structure, options, exact) bind(c)
      import
      type(c_ptr), value :: structure, options
      type(c_ptr) :: exact
    end function
    integer(c_int) function meniscus_measure(exact, totals, errors) bind(c)
      import
      type(c_ptr), value :: exact
      type(totals_type) :: totals, errors
    end function
    type(c_ptr) function meniscus_last_error() bind(c)
      import
    end function
    integer(c_size_t) function strlen(text) bind(c)
      import
      type(c_ptr), value :: text
    end function
    subroutine meniscus_structure_free(structure) bind(c)
      import
      type(c_ptr), value :: structure
    end subroutine
    subroutine meniscus_exact_free(exact) bind(c)
      import
      type(c_ptr), value :: exact
    end subroutine
  end interface

contains

  subroutine check(status)
    integer(c_int), intent(in) :: status
    character(kind=c_char), pointer :: text(:)
    if (status == 0) return
    call c_f_pointer(meniscus_last_error(), text, [strlen(meniscus_last_error())])
    print '(*(a))', text
    stop 1
  end subroutine

end module

program areas
  use meniscus
  implicit none
  real(c_double) :: centres(3, 2) = reshape([0d0, 0d0, 0d0, 3d0, 0d0, 0d0], [3, 2]), radii(2) = [1.7d0, 1.52d0]
  type(totals_type) :: totals, errors
  type(c_ptr) :: structure, exact

  call check(meniscus_from_spheres(2_c_size_t, centres, radii, structure))
  call check(meniscus_exact_new(structure, c_null_ptr, exact))
  call check(meniscus_measure(exact, totals, errors))
  print '(a, f12.6, a, es8.1)', 'SES area', totals%ses_area, ' +-', errors%ses_area
  call meniscus_exact_free(exact)
  call meniscus_structure_free(structure)
end program
