#pragma once
#include <string>

namespace gapcheck::results::fixtures {

/// Two records of a run's initialisation: a quad whose node is far from the edges, a triangle hit at a corner.
inline const std::string smp_penetrations =
    R"( Beginning of keyword reader                                   08/05/24 13:44:59
 expanding   memory to       20720 d     1975268  
 
 *** Warning 40565 (SOL+565)
     Initialization
     contact interface #                    = 1
     penetrating node #                     = 14
     segment #                              = 223
     penetration                            = -5.0000E-01
     remaining distance to shell midsurface =  5.0000E-01
     s,t                                    = -2.3980E-01 -8.0082E-02
     penetrated segment nodes:
 22124 22164 22165 22125
     original coordinates of slave node     = 14
     x-coordinate                           = -2.8868E+01
     y-coordinate                           = -4.9561E+00
     z-coordinate                           =  0.0000E+00
     modified coordinates of slave node     = 14
     x-coordinate                           = -2.8868E+01
     y-coordinate                           = -4.9561E+00
     z-coordinate                           =  5.0100E-01
 
 *** Warning 40565 (SOL+565)
     Initialization
     contact interface #                    = 2
     penetrating node #                     = 21798
     segment #                              = 17
     penetration                            = -7.4900E-01
     remaining distance to shell midsurface =  2.5100E-01
     s,t                                    =  1.0000E+00 -1.0000E+00
     penetrated segment nodes:
 21597 21130 21600 21600
     original coordinates of slave node     = 21798
     x-coordinate                           =  1.7925E+01
     y-coordinate                           = -7.5000E-02
     z-coordinate                           =  5.0100E-01
     modified coordinates of slave node     = 21798
     x-coordinate                           =  1.7925E+01
     y-coordinate                           = -7.5000E-02
     z-coordinate                           =  1.2515E+00
 contracting memory to        3538 d     3600686 contact segment data 1
)";

/// A d3hsp's part on contacts. Its lines on settings have the word penetration and are no finding.
inline const std::string d3hsp_contacts = R"(total # of *CHANGE_CONTACT_SMALL_PENETRATION.......       0
    track initial penetrations in auto contacts....       2
          eq.0:  no, move node to contact surface      
          eq.1:  yes, initial penetrations remain      
    contact initial penetration check option.......       1

 c o n t a c t   i n t e r f a c e s
 ***********************************************************************

 Contact Interface      7

Door on sill                                                          


       contact type.................................   a 3
            type.eq.2  tied                             
       contact interface ID .......................         7
       contact order within input deck .............        1
       no. of surfa segments........................      300
       no. of surfb segments........................       15
       small penetration in contact search .........        0
            .eq.1 penetration.gt..1*thic of element ignored
            eq.0:move penetrating nodes        
                 initial penetrations, penetrations are

 Contact Interface      3

                                                                      


       contact type.................................    13
       contact order within input deck .............        2
       no. of surfa segments........................      120
       no. of surfb segments........................        0

 ***********************************************************************


  Contact summary 

  Order #  Contact ID   Type                     Title

        1           7    a 3 Door on sill                                                          
        2           3     13                                                                       
        3          12    o 2 Weld line                                                             

 ***********************************************************************
 

 100 smallest timesteps
 ------------------------------------------------
 element       number                part    timestep
 shell          14351                   1  1.6611E-07
 solid          14101                   1  1.7000E-07

)";

/// One tie message; `header` is what follows "*** Warning ", `who` slave or tracked.
inline std::string tie(const std::string& header, const std::string& sentence, const std::string& who, int contact,
                       int node, int segment = 0) {
  std::string text = " \n *** Warning " + header + "\n     " + sentence +
                     "\n     tied interface #           = " + std::to_string(contact) + "\n     " +
                     (who + " node #                 ").substr(0, 27) + "= " + std::to_string(node) + "\n";
  if (segment > 0) text += "     segment #                  = " + std::to_string(segment) + "\n";
  return text;
}

}  // namespace gapcheck::results::fixtures
